/// The entries of the catalogue, one function and one file each.
#pragma once

#include "seiche/exact/catalogue.hpp"

namespace seiche::exact {

ExactSolution riemann_entry();
ExactSolution bore_reflection_entry();
ExactSolution simple_wave_entry();
ExactSolution steady_bump_entry();
ExactSolution macdonald_entry();
ExactSolution thacker_entry();
ExactSolution airy_entry();
ExactSolution dispersion_entry();
ExactSolution frank_dispersion_entry();
ExactSolution lagrangian_mesh_dispersion_entry();
ExactSolution plan_dispersion_entry();
ExactSolution hexahedral_dispersion_entry();
ExactSolution plan_manufactured_entry();
ExactSolution serre_solitary_entry();
ExactSolution serre_cnoidal_entry();
ExactSolution solitary_asymptotic_entry();
ExactSolution solitary_entry();
ExactSolution stokes_entry();
ExactSolution standing_entry();
ExactSolution dispersive_standing_entry();
ExactSolution gerstner_entry();
ExactSolution affine_drop_entry();
ExactSolution affine_ellipsoid_entry();
ExactSolution mach_reflection_entry();
ExactSolution solitary_runup_entry();
ExactSolution hall_watts_entry();
ExactSolution wall_load_entry();
ExactSolution wall_runup_entry();
ExactSolution slope_runup_entry();
ExactSolution wavemaker_entry();
ExactSolution wavemaker_start_entry();
ExactSolution thacker_radial_entry();
ExactSolution thacker_planar_entry();
ExactSolution overturning_wave_entry();
ExactSolution pressure_forced_wave_entry();
ExactSolution released_column_entry();
ExactSolution soliton_fission_entry();

}  // namespace seiche::exact
