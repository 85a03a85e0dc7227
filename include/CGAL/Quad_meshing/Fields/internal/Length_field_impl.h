// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_LENGTH_FIELD_IMPL_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_LENGTH_FIELD_IMPL_H

#include <CGAL/Quad_meshing/Fields/Length_field.h>
#include <CGAL/Quad_meshing/Fields/internal/curvature_guides.h>
#include <CGAL/Quad_meshing/Fields/internal/face_lengths.h>
#include <CGAL/Quad_meshing/Fields/internal/find_feature_sizes.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE bool Length_field::measure(const std::vector<char>& is_feature, Any_visitor& visitor)
{
  if(m_options.method == Sizing_method::CONSTANT)
    return true;
  const Visited_stage stage(visitor, "sizes");
  Stage_progress progress(visitor);
  if(m_options.method == Sizing_method::FEATURE_SIZE)
    return find_feature_sizes(m_mesh, progress, m_size);
  // What is smaller than the shortest edges does not count.
  const double least = m_options.smallest > 0 ? m_options.smallest : m_options.constant / 4;
  return find_curvature_radii(m_mesh, is_feature, least, progress, m_size);
}

CGAL_QUAD_MESHING_INLINE double Length_field::adapted(int f, double factor) const
{
  // Edges vary about the length asked for, and their distances from the surface by its square: with so much of the
  // length that reaches the distance, they keep it on average.
  const double share_of_chord = 0.8;
  switch(m_options.method)
  {
    case Sizing_method::CONSTANT: return factor * m_options.constant;
    case Sizing_method::CURVATURE:
      if(m_options.tolerance > 0)
        return share_of_chord * chord_length(m_size[f], m_options.tolerance);
      // Without a tolerance, a factor of one is that of a hundredth of the constant length.
      return chord_length(m_size[f], factor * factor * m_options.constant / 100);
    case Sizing_method::FEATURE_SIZE: return factor * m_size[f];
  }
  return 0;
}

CGAL_QUAD_MESHING_INLINE std::vector<double> Length_field::lengths(double factor_of_wishes,
                                                                   double factor_of_others) const
{
  const Options& o = m_options;
  const double range = 4; // of lengths that adapt, about the constant one
  std::vector<double> result(m_mesh.number_of_faces());
  for(int f = 0; f < m_mesh.number_of_faces(); ++f)
  {
    const bool is_wished = m_wish[f] > 0, adapts = !is_wished && o.method != Sizing_method::CONSTANT;
    double& l = result[f];
    l = is_wished ? factor_of_wishes * m_wish[f] : adapted(f, factor_of_others);
    if(o.largest > 0 || adapts)
      l = (std::min)(l, o.largest > 0 ? o.largest : range * o.constant);
    if(o.smallest > 0 || adapts)
      l = (std::max)(l, o.smallest > 0 ? o.smallest : o.constant / range);
  }
  limit_gradation(m_mesh, o.gradation, result);
  return result;
}

CGAL_QUAD_MESHING_INLINE double Length_field::number_of_quads(const std::vector<double>& lengths) const
{
  return quads_of_lengths(m_mesh, lengths);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_LENGTH_FIELD_IMPL_H
