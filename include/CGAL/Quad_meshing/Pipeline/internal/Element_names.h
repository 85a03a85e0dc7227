// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_ELEMENT_NAMES_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_ELEMENT_NAMES_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>

#include <cstddef>
#include <functional>
#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What messages call the elements of the input: as the caller says, else by their numbers.
class Element_names
{
  std::function<std::string(std::size_t)> m_face, m_vertex;

public:
  Element_names() = default;

  explicit Element_names(const Quadrangulation_options& options)
    : m_face(options.face_name), m_vertex(options.vertex_name)
  {
  }

  std::string face(std::size_t i) const { return m_face ? m_face(i) : "face " + std::to_string(i); }
  std::string vertex(std::size_t i) const { return m_vertex ? m_vertex(i) : "vertex " + std::to_string(i); }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_ELEMENT_NAMES_H
