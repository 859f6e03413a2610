# Writes the opening comment of SOURCE, a Markdown article, into OUTPUT as the string seiche::validation::articles::NAME.
file(READ ${SOURCE} text)
string(FIND "${text}" "/*" begin)
string(FIND "${text}" "*/" end)
if(NOT begin EQUAL 0 OR end LESS 3)
  message(FATAL_ERROR "${SOURCE} must open with its article: a comment /* ... */ in Markdown")
endif()
math(EXPR length "${end} - 2")
string(SUBSTRING "${text}" 2 ${length} article)
string(STRIP "${article}" article)
# A string literal of a compiler has a limited length: one literal per line, joined by the compiler.
string(REPLACE "\\" "\\\\" article "${article}")
string(REPLACE "\"" "\\\"" article "${article}")
string(REPLACE "\n" "\\n\"\n    \"" article "${article}")
file(WRITE ${OUTPUT} "namespace seiche::validation::articles {
extern const char* const ${NAME};
const char* const ${NAME} =
    \"${article}\";
}  // namespace seiche::validation::articles
")
