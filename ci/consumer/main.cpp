// A project of somebody else's that uses the installed library.
#include <cstdio>

#include <seiche/shallow_water/relations.hpp>

int main() {
  const auto star = seiche::shallow_water::star_state(9.81, {1.0, 0.0}, {0.1, 0.0});
  std::printf("depth behind the bore: %.15f m\n", star.depth);
  return star.depth > 0.396 && star.depth < 0.397 ? 0 : 1;
}
