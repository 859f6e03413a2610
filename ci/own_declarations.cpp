// A plugin of clang-tidy (ci/tidy): its checks walk the project's own declarations and not those of the standard
// library, Eigen or Catch2, where nothing is reported anyway and four fifths of the time went. clang's analyzer, which
// comes after the checks, is left as it is.

#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>
#include <clang/AST/ASTContext.h>
#include <clang/ASTMatchers/ASTMatchFinder.h>

#include <vector>

namespace seiche {
namespace {

using clang::ast_matchers::MatchFinder;

class OwnDeclarations : public clang::tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;

  void registerMatchers(MatchFinder* finder) override {
    finder->addMatcher(clang::ast_matchers::translationUnitDecl(), this);
  }

  // The unit itself is matched before what it declares is walked.
  void check(const MatchFinder::MatchResult& result) override {
    context_ = result.Context;
    std::vector<clang::Decl*> own;
    for (clang::Decl* declaration : context_->getTranslationUnitDecl()->decls()) {
      // A test's place is where its macro stands, not where Catch2 wrote the macro.
      auto const place = result.SourceManager->getExpansionLoc(declaration->getLocation());
      if (!result.SourceManager->isInSystemHeader(place)) own.push_back(declaration);
    }
    context_->setTraversalScope(own);
  }

  void onEndOfTranslationUnit() override {
    if (context_ != nullptr) context_->setTraversalScope({context_->getTranslationUnitDecl()});
  }

 private:
  clang::ASTContext* context_ = nullptr;
};

class OwnModule : public clang::tidy::ClangTidyModule {
 public:
  void addCheckFactories(clang::tidy::ClangTidyCheckFactories& factories) override {
    factories.registerCheck<OwnDeclarations>("seiche-own-declarations");
  }
};

clang::tidy::ClangTidyModuleRegistry::Add<OwnModule> const added("seiche", "What is the project's own");

}  // namespace
}  // namespace seiche
