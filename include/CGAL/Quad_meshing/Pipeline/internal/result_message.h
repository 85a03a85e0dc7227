// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RESULT_MESSAGE_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RESULT_MESSAGE_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_result.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Element_names.h>
#include <CGAL/Quad_meshing/Pipeline/internal/quad_counts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The parts of the message of a run, which follow each other after semicolons.

inline std::string without_period(std::string sentence)
{
  while(!sentence.empty() && sentence.back() == '.')
    sentence.pop_back();
  return sentence;
}

// A bad component does not cost the others: the message names those that are not as they should be.
inline std::string names_of_invalid_components(const Quadrangulation_result& result, const Element_names& names)
{
  const std::vector<Invalid_component>& bad = result.invalid_components;
  std::string message = std::to_string(bad.size()) + " of " + std::to_string(result.components) + " components " +
                        (bad.size() == 1 ? "has" : "have") + " no valid quad mesh";
  const std::size_t most_named = 5, named = (std::min)(bad.size(), most_named);
  for(std::size_t i = 0; i < named; ++i)
    message += (i == 0 ? ": that of " : "; that of ") + names.face(bad[i].face) + ": " + without_period(bad[i].message);
  if(bad.size() > named)
    message += "; and " + std::to_string(bad.size() - named) + " more";
  return message;
}

// What remarks depend on besides the figures and the options.
struct Remark_context
{
  bool keeps_number = true; // the number of quads is asked for, and nothing that is more important than it
  bool is_time_up = false;
  std::size_t copies = 1; // how many times the quads are there in the end, with their mirror images
};

// What the result gave up of what was asked for, and why.
inline std::string remarks(const Quadrangulation_result& result, const Quadrangulation_options& options,
                           const Remark_context& context)
{
  std::string text;
  if(result.released_feature_share != 0)
    text += "; " + std::to_string(std::lround(100 * result.released_feature_share)) +
            " percent of the length of the sharp edges left no room for quads along them and were not followed";
  if(result.dropped_feature_edges != 0)
    text += "; " + std::to_string(result.dropped_feature_edges) +
            (result.dropped_feature_edges == 1 ? " sharp edge was" : " sharp edges were") +
            " taken for noise at this size of quads";
  if(result.folded_quads != 0)
    text +=
      "; " + std::to_string(result.folded_quads) + (result.folded_quads == 1 ? " quad is" : " quads are") + " inverted";
  if(result.refined_components != 0)
    text += "; " + std::to_string(result.refined_components) +
            (result.refined_components == 1 ? " small component has" : " small components have") + " smaller quads";
  if(result.not_semi_regular_components != 0)
    text += "; " + std::to_string(result.not_semi_regular_components) +
            (result.not_semi_regular_components == 1 ? " component was" : " components were") +
            " not made anew along the base complex, which gave no better quads";
  if(result.divided_vertices != 0)
    text +=
      "; " + std::to_string(result.divided_vertices) +
      (result.divided_vertices == 1 ? " vertex in which borders touch was" : " vertices in which borders touch were") +
      " divided";
  if(context.is_time_up && result.quads > 0)
    text += "; the time limit ended the search for a better one";
  for(const std::string& unmet : result.unmet_guides)
    text += "; " + unmet;
  const double quads = static_cast<double>(result.quads + result.other_faces);
  if(context.keeps_number && result.quads > 0 && result.failed_components == 0 &&
     !is_as_promised(quads, options.target_number_of_quads))
    text += "; " + std::to_string(context.copies * result.quads) + " quads instead of " +
            std::to_string(std::lround(static_cast<double>(context.copies) * options.target_number_of_quads)) +
            (quads > options.target_number_of_quads
               ? ", as narrow places between features, borders and singularities need at least a quad each"
             : options.optimize_structure || options.semi_regular
               ? ", as the coarser structure has room for no more"
               : ", as rounding to whole quads found no number nearer to it");
  return text;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RESULT_MESSAGE_H
