/// Passes over long vectors for iterative solvers, several operations at a time: they are limited by memory.
///
/// Threads share chunks of fixed length; sums are taken within each chunk and then in order, so that results do not
/// depend on the number of threads. All spans of one call have the same length; outputs do not overlap inputs.
#pragma once

#include <array>
#include <span>

namespace seiche::linear {

/// x . y
double dot(std::span<const double> x, std::span<const double> y);
/// x . y and x . z
std::array<double, 2> dots(std::span<const double> x, std::span<const double> y, std::span<const double> z);
/// y = x + factor y
void scale_and_add(std::span<const double> x, double factor, std::span<double> y);
/// difference = x - difference; returns its square.
double subtract_from(std::span<const double> x, std::span<double> difference);
/// x += step p, r -= step q; returns r . r.
double advance(double step, std::span<const double> p, std::span<const double> q, std::span<double> x,
               std::span<double> r);

}  // namespace seiche::linear
