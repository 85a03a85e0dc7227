// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_QUANTIZE_T_MESH_H
#define CGAL_QUAD_MESHING_LAYOUT_QUANTIZE_T_MESH_H

#include <CGAL/Quad_meshing/Layout/internal/T_mesh_grid.h>
#include <CGAL/Quad_meshing/Layout/internal/T_mesh_lengths.h>
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingLayoutRef

\brief What `quantize_t_mesh()` tells.
*/
struct T_mesh_quantization_result
{
  bool is_valid = false;           ///< whether there are lengths
  double energy = 0;               ///< of the lengths; 0 is a lower bound, that of the real lengths
  double rounded_energy = 0;       ///< of the rounded lengths that it started from
  std::size_t lengthened_arcs = 0; ///< that had to become longer than the energy alone would make them
  std::size_t zero_arcs = 0;       ///< of length 0
  std::size_t number_of_quads = 0; ///< that the lengths stand for
  double seconds = 0;              ///< wall-clock time
  std::string message = "";        ///< a sentence
};

/*!
\ingroup PkgQuadMeshingLayoutRef

\brief chooses integer lengths for the arcs of a T-mesh, from which a quad mesh can be made without fail.

Opposite sides of every patch are equally long. Arcs may have length 0, which lets lines of the T-mesh come together: so
there need not be more quads than were asked for. But critical nodes stay apart from each other and from features that
they do not lie on, features stay apart from each other, no loop that cannot be drawn together to a point has length 0,
and the quads form a mesh.

The lengths start from the rounded ones. Arcs that are shorter than they may be are lengthened along cheapest dual
walks, and walks are taken as long as they lessen the Dirichlet energy of the differences between integer and real
lengths. Then all that becomes one point, or one edge, is looked at; where it must not, an arc is lengthened, and so on.
As the lower bounds only grow, and lengths with all arcs positive have no conflicts, this ends.

\param t the T-mesh
\param lengths receives the lengths, one per arc

\return what was done; it is not valid if `t` is not, or if the quads form no mesh however long the arcs are

\sa `quads_of_t_mesh()`
*/
inline T_mesh_quantization_result quantize_t_mesh(const T_mesh& t, std::vector<int>& lengths)
{
  Real_timer timer;
  timer.start();
  T_mesh_quantization_result result;
  if(!t.is_valid())
  {
    result.message = t.message;
    return result;
  }
  lengths.clear();
  for(const T_mesh::Arc& a : t.arcs)
    lengths.push_back(static_cast<int>(a.rounded_length));
  std::vector<int> at_least(t.arcs.size(), 0);
  internal::T_mesh_lengths search(t, lengths, at_least);
  result.rounded_energy = search.energy();
  // A bound on the bounds: patches of three by three quads have no two vertices that are joined twice. Each round
  // lengthens one arc at least.
  const int longest_bound = 4;
  while(true)
  {
    if(!search.satisfy_bounds())
    {
      result.message = "An arc of the T-mesh lies on no dual walk.";
      return result;
    }
    search.improve();
    std::vector<int> arcs = internal::Collapsed_t_mesh(t, lengths).conflicts();
    internal::T_mesh_grid grid(t, lengths);
    if(arcs.empty())
      arcs = grid.defects();
    if(arcs.empty())
    {
      result.number_of_quads = grid.quads.size();
      break;
    }
    bool is_longer = false;
    for(int a : arcs)
      if(a != -1 && at_least[a] < longest_bound)
      {
        at_least[a] = (std::min)(longest_bound, (std::max)(at_least[a], lengths[a]) + 1);
        is_longer = true;
      }
    if(!is_longer)
    {
      result.message = "The quads of the T-mesh form no mesh.";
      return result;
    }
  }
  result.energy = search.energy();
  result.lengthened_arcs = std::count_if(at_least.begin(), at_least.end(), [](int n) { return n > 0; });
  result.zero_arcs = std::count(lengths.begin(), lengths.end(), 0);
  result.seconds = timer.time();
  result.message = "The T-mesh has " + std::to_string(result.number_of_quads) + " quads.";
  result.is_valid = true;
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_QUANTIZE_T_MESH_H
