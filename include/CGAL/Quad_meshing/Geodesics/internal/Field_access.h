// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_ACCESS_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_ACCESS_H

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the functions that continue from a field may look at.
struct Field_access
{
  template <typename Field>
  static const auto& mesh(const Field& f)
  {
    return f.m_mesh;
  }
  template <typename Field>
  static const auto& sources(const Field& f)
  {
    return f.m_sources;
  }
  template <typename Field>
  static const auto& graph(const Field& f)
  {
    return f.m_tm;
  }
  template <typename Field, typename Vertex>
  static int index(const Field& f, Vertex v)
  {
    return f.index(v);
  }

  // null if there is no field, or none with windows
  template <typename Field>
  static const auto* propagation(const Field& f)
  {
    return f.m_has_windows ? f.m_propagation.get() : nullptr;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_ACCESS_H
