/// SEICHE_SIMD_CLONES before a function that is one hot loop: compiled for any x86-64, for AVX2 and for AVX-512, and
/// chosen when the program starts. The binary still runs everywhere; results differ between them by round-off only.
#pragma once

// Sanitizers start before the choice is made, so they get the plain function. So does a build whose flags have the
// instructions: what is compiled for this machine cannot be inlined into a version for a named one.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__AVX2__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SEICHE_SIMD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define SEICHE_SIMD_CLONES
#endif

/// SEICHE_INLINE before a small function that such loops call: inlined into each of the versions, whatever its size.
#if defined(__GNUC__)
#define SEICHE_INLINE [[gnu::always_inline]] inline
#else
#define SEICHE_INLINE inline
#endif
