// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_SMOOTHING_REFERENCE_H
#define CGAL_QUAD_MESHING_SMOOTHING_SMOOTHING_REFERENCE_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <memory>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the vertices of a quad mesh move on: a surface, the curves of its features, its borders. What it offers to other
// rooms is to be made once and to be smoothed on as often as they like; a search structure is built at its first use.
class Smoothing_reference
{
public:
  // A triangle mesh. Where it has no features, or no borders, those of the quad mesh as it is now are taken.
  CGAL_QUAD_MESHING_INLINE Smoothing_reference(const Indexed_quad_mesh& qm, Indexed_reference tm);

  // The surface of the quad mesh itself, each quad cut into two triangles.
  CGAL_QUAD_MESHING_INLINE explicit Smoothing_reference(const Indexed_quad_mesh& qm);

  CGAL_QUAD_MESHING_INLINE Smoothing_reference(Smoothing_reference&& other);
  CGAL_QUAD_MESHING_INLINE ~Smoothing_reference();

  // Whether there is nothing to move on: no triangle has a positive area.
  CGAL_QUAD_MESHING_INLINE bool is_empty() const;

  struct Data; // known to the smoothers only
  Data& data() { return *m_data; }

private:
  std::unique_ptr<Data> m_data;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Smoothing/internal/Smoothing_reference_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_SMOOTHING_SMOOTHING_REFERENCE_H
