# Prepares a header for Doxygen, line by line; the source stays plain.
#
# - The comment above #pragma once becomes that of the file.
# - A public header of the same folder named in a comment becomes a link: most folders have a model.hpp and a flow.hpp.
# - mechanics::OneStep is found from everywhere.
# - "ch. 3" does not end the first sentence.
use strict;
use warnings;

my ($folder) = $ARGV[0] =~ m{^(?:.*/)?solver/(.*)/} ? "solver/$1" : "";
(my $room = $folder) =~ s{^solver/}{};
open(my $front, "<", "ci/docs_pages/main_page.dox") or die;
my %public = map { $_ => 1 } join("", <$front>) =~ m{((?:seiche|evidence)/[a-z_0-9/]+\.hpp)}g;
while (<>) {
  s{^#pragma once$}{/// \@file};
  if (m{//[/!]} && !m{//[/!] {5}}) {
    s{\b(ch|e\.g|i\.e|art|ed)\. }{$1.\\ }g;
    s{(?<![\w:])(?=(?:mechanics|linear|exact|plan_lattice|io|evidence)::[A-Z])}{seiche::}g;
    s{(?<![\w/])(\w+\.hpp)\b}{$public{"$room/$1"} ? "\@ref $room/$1 \"$1\"" : $1}ge;
  }
  print;
}
