/// The lines of a two-dimensional Lagrangian mesh in a figure.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "reports/evidence/figure.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"

namespace seiche::validation {

/// Part of the mesh between two places [m]: the columns that have a node there, and their neighbours.
struct MeshWindow {
  double begin = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();
};

/// Axes of one scale, with the window's ends where they are finite.
evidence::Axes mesh_axes(const std::string& title, const MeshWindow& window = {});

/// Columns and rows through the given nodes, as one line of the panel. Throws std::invalid_argument when fewer than two
/// columns of nodes are in the window.
void draw_mesh(evidence::Panel& panel, const std::string& label, const lagrangian_mesh_2d::Mesh& mesh,
               std::span<const double> x, std::span<const double> y, const MeshWindow& window = {},
               evidence::Role role = evidence::Role::computed);
/// Nodes of the surface that are in the window.
struct SurfaceNodes {
  std::vector<double> x, y;
};
SurfaceNodes surface_nodes(const lagrangian_mesh_2d::Flow& flow, const MeshWindow& window);
/// As it is now.
void draw_mesh(evidence::Panel& panel, const std::string& label, const lagrangian_mesh_2d::Flow& flow,
               const MeshWindow& window = {}, evidence::Role role = evidence::Role::computed);

}  // namespace seiche::validation
