// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_STAR_LAYOUT_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_STAR_LAYOUT_H

#include <CGAL/Quad_meshing/Parameterization/internal/Face_gradients.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Vertex_sectors.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Places the stars of folded irregular vertices in the map as they should be, whatever the map is now.
class Star_layout
{
public:
  // `number` is -1 for the variables that are fixed.
  Star_layout(const Seamless_coordinates& coordinates, const Face_gradients& faces, const Vertex_sectors& sectors,
              const std::vector<int>& number)
    : m_coordinates(coordinates), m_mesh(coordinates.charts.mesh), m_faces(faces), m_sectors(sectors), m_number(number)
  {
  }

  // Lays out the neighbours of irregular vertices with folded faces: in their order, at angles in the proportion of
  // those on the surface and that fill the sector, at a part of their distance. Returns which variables have got a
  // place.
  std::vector<bool> open(const std::vector<int>& folded_faces, Eigen::VectorXd& x) const
  {
    std::vector<bool> is_folded(m_mesh.number_of_faces(), false), is_placed(m_coordinates.number_of_variables(), false);
    for(int f : folded_faces)
      is_folded[f] = true;
    for(const Vertex_sectors::Sector& sector : m_sectors.list)
      if(sector.is_irregular &&
         std::any_of(sector.halfedges.begin(), sector.halfedges.end(), [&](int h) { return is_folded[h / 3]; }))
        open_sector(sector, x, is_placed);
    return is_placed;
  }

private:
  const Seamless_coordinates& m_coordinates;
  const Indexed_triangle_mesh& m_mesh;
  const Face_gradients& m_faces;
  const Vertex_sectors& m_sectors;
  const std::vector<int>& m_number; // per variable: -1 if it is fixed

  void open_sector(const Vertex_sectors::Sector& sector, Eigen::VectorXd& x, std::vector<bool>& is_placed) const
  {
    double total = 0;
    for(int h : sector.halfedges)
      total += Vertex_sectors::angle_at_source(m_mesh, h);
    const double scale = total > 0 ? sector.quarters * Vertex_sectors::right_angle / total : 0;

    // Directions in the chart of the face of each halfedge; `turned` counts the quarters from the first chart.
    std::vector<double> direction(sector.halfedges.size());
    Eigen::Vector2d mean(0, 0);
    double along = 0;
    int turned = 0;
    for(std::size_t i = 0; i < direction.size(); ++i)
    {
      const int h = sector.halfedges[i];
      direction[i] = along + turned * Vertex_sectors::right_angle;
      const Eigen::Vector2d d = in_field_frame(h);
      const double off = std::atan2(d.y(), d.x()) - direction[i];
      mean += Eigen::Vector2d(std::cos(off), std::sin(off));
      along += scale * Vertex_sectors::angle_at_source(m_mesh, h);
      if(i + 1 < direction.size())
        turned += m_coordinates.charts.quarters_across(Indexed_triangle_mesh::prev(h));
    }
    const double offset = sector.is_anchored
                            ? m_coordinates.quarter_of(sector.halfedges.front()) * Vertex_sectors::right_angle
                            : std::atan2(mean.y(), mean.x());
    for(std::size_t i = 0; i < direction.size(); ++i)
    {
      const int h = sector.halfedges[i];
      place(h, Indexed_triangle_mesh::next(h), direction[i] + offset, in_field_frame(h).norm(), x, is_placed);
    }
    if(sector.is_anchored)
      place(sector.halfedges.back(), sector.last, along + turned * Vertex_sectors::right_angle + offset,
            in_field_frame(sector.last).norm(), x, is_placed);
  }

  // Moves the free coordinates of a corner to a place seen from another corner of the same face.
  void place(int center, int corner, double direction, double distance, Eigen::VectorXd& x,
             std::vector<bool>& is_placed) const
  {
    const double relative_radius = 0.5;
    const int from = m_coordinates.charts.wedge_of_corner[center], w = m_coordinates.charts.wedge_of_corner[corner];
    const double target[2] = { m_coordinates.value(from, 0, x) + relative_radius * distance * std::cos(direction),
                               m_coordinates.value(from, 1, x) + relative_radius * distance * std::sin(direction) };
    for(int c = 0; c < 2; ++c)
      for(const auto& t : m_coordinates.coordinates[w][c])
        if(m_number[t.first] != -1)
        {
          x[t.first] += (target[c] - m_coordinates.value(w, c, x)) / t.second;
          is_placed[t.first] = true;
          break;
        }
  }

  // The vector of h in the frame of the combed field, in units of the target edge length.
  Eigen::Vector2d in_field_frame(int h) const
  {
    Eigen::Matrix2d M; // two rows of the gradient are the inverse of the two edge vectors at corner 0
    M.row(0) = m_faces.gradient[h / 3].row(1);
    M.row(1) = m_faces.gradient[h / 3].row(2);
    const Eigen::Matrix2d E = M.inverse();
    Eigen::Matrix<double, 2, 3> p;
    p << Eigen::Vector2d(0, 0), E.col(0), E.col(1);
    return p.col((h + 1) % 3) - p.col(h % 3);
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_STAR_LAYOUT_H
