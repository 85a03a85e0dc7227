// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_READ_NUMBER_ROWS_H
#define CGAL_QUAD_MESHING_IO_READ_NUMBER_ROWS_H

#include <CGAL/Quad_meshing/IO/Guide_reading_result.h>
#include <CGAL/Quad_meshing/IO/internal/Text_scanner.h>
#include <CGAL/Quad_meshing/IO/internal/read_text_file.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief A line of numbers of a file.
 */
struct Number_row
{
  std::size_t line = 0;        ///< the number of the line, counted from 1
  std::vector<double> numbers; ///< at least one, all of them finite
};

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief reads lines of numbers.
 *
 * Numbers are separated by blanks. Empty lines are skipped, and so is everything behind a `#` in a line.
 *
 * \param filename the name of the file
 * \param rows receives the lines that have numbers
 *
 * \return what is wrong, if something is: the file cannot be opened, holds no number, or has something else than finite
 * numbers in it
 */
inline Guide_reading_result read_number_rows(const std::string& filename, std::vector<Number_row>& rows)
{
  Guide_reading_result result;
  rows.clear();
  std::string text;
  if(!internal::read_text_file(filename, text))
  {
    result.message = "The file cannot be opened.";
    return result;
  }
  internal::Text_scanner in(text);
  for(in.skip_to_item(); !in.at_end(); in.skip_to_item())
  {
    Number_row row;
    row.line = in.line();
    for(in.skip_blanks(); !in.at_line_end(); in.skip_blanks())
    {
      double x = 0;
      if(!in.read(x))
        break;
      if(!std::isfinite(x))
        in.fail("a number is not finite");
      row.numbers.push_back(x);
    }
    rows.push_back(row);
  }
  result.message = in.error();
  if(result.is_valid() && rows.empty())
    result.message = "The file has no numbers.";
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_READ_NUMBER_ROWS_H
