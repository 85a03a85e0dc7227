// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_WINDOWS_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_WINDOWS_H

#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Group_windows.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Wavefront.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The windows on the open edges of a mesh, group by group when one asks for them. Any number of threads may ask at a
// time: should two make the same group, they make the same windows, and those of one of them stay.
template <typename FT>
class Open_windows
{
public:
  typedef Unfolded_mesh<FT> Mesh;
  typedef Group_windows<FT> Group;

  Open_windows(const Wavefront<FT>& front, const Field_sources<FT>& sources, double allowed_error)
    : m_front(front), m_sources(sources), m_allowed_error(allowed_error), m_groups(front.mesh().number_of_faces())
  {
  }

  Open_windows(const Open_windows&) = delete;
  Open_windows& operator=(const Open_windows&) = delete;

  ~Open_windows()
  {
    // backwards, as the first face of a group, which owns it, is the last one that is looked at
    for(int f = static_cast<int>(m_groups.size()) - 1; f >= 0; --f)
    {
      const Group* const group = m_groups[f].load(std::memory_order_relaxed);
      if(group != nullptr && group->first_face() == f)
        delete group;
    }
  }

  Window_list<FT> operator()(int edge) const
  {
    const int face = Mesh::face(m_front.mesh().halfedge_of_edge[edge]);
    const Group* group = m_groups[face].load(std::memory_order_acquire);
    return (group != nullptr ? group : add(face))->windows(edge);
  }

  // How many there are. Groups that nobody has asked for are made and dropped.
  std::size_t count() const
  {
    std::size_t n = 0;
    std::vector<bool> is_counted(m_groups.size(), false);
    for(int f = 0; f < static_cast<int>(m_groups.size()); ++f)
    {
      if(is_counted[f])
        continue;
      for(int g : m_front.open_edges().group(f))
        is_counted[g] = true;
      const Group* const group = m_groups[f].load(std::memory_order_acquire);
      n += group != nullptr ? group->number_of_windows()
                            : Group(m_front, m_sources, m_allowed_error, f).number_of_windows();
    }
    return n;
  }

private:
  const Group* add(int face) const
  {
    std::unique_ptr<const Group> made(new Group(m_front, m_sources, m_allowed_error, face));
    const Group* group = nullptr;
    // the slot of the first face decides whose it is
    if(m_groups[made->first_face()].compare_exchange_strong(group, made.get(), std::memory_order_acq_rel))
      group = made.release();
    for(int f : m_front.open_edges().group(face))
      m_groups[f].store(group, std::memory_order_release);
    return group;
  }

  const Wavefront<FT>& m_front;
  const Field_sources<FT>& m_sources;
  double m_allowed_error;
  mutable std::vector<std::atomic<const Group*>> m_groups; // per face, that of the first face of a group owns it
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_WINDOWS_H
