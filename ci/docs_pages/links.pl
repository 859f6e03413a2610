# Prepares a Markdown page for Doxygen: a link to a page of the guide stays one, any other becomes its words.
use strict;
use warnings;
use File::Basename;

(my $folder = dirname($ARGV[0])) =~ s{^.*?(?=(?:examples|ci/docs_pages)(?:/|$)|$)}{};
while (<>) {
  s{!\[[^\]]*\]\([^)]*\)}{}g;
  s{\[([^\]]*)\]\((?!https?:)([^)]*)\)}{
    my ($words, $file) = ($1, $folder ? "$folder/$2" : $2);
    1 while $file =~ s{[^/]+/\.\./}{};
    $file =~ m{^(?:README|CONTRIBUTING|examples/.*|ci/docs_pages/.*)\.md$} ? "[$words](\@ref $file)" : $words
  }ge;
  print;
}
