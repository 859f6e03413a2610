/// Response of n equal rows (layers) of constant-volume cells to a wave at their surface.
///
/// Multipliers vary over the rows like cosh(2 (j + 1/2) artanh T), j = 0 at the bottom. The frequency is
/// omega^2 = (2 g/h) G R with h the height of a row and G the symbol of the potential energy;
///
///     R = T (1 - T^2) t_n/(1 - T t_n + 2 b T (1 - T^2) t_n),   t_n = tanh(2 n artanh T),   2 b R < 1.
///
/// T is half the height of a row times the wavenumber that the cells see, b the vertical inertia of a surface node over
/// that of an inner one.
#pragma once

#include <cstddef>

namespace seiche::exact {

/// R for T = sine/cosine, both not negative and not both 0: T may be infinite.
double layer_response(double sine, double cosine, std::size_t rows, double inertia);

/// The same without the closed form, row by row from the bottom.
double layer_response_by_rows(double sine, double cosine, std::size_t rows, double inertia);

}  // namespace seiche::exact
