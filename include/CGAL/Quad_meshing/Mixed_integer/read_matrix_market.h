// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_READ_MATRIX_MARKET_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_READ_MATRIX_MARKET_H

#include <Eigen/SparseCore>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <istream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief reads a real matrix in the Matrix Market format.

Both forms are known, `coordinate` and `array`, with numbers of kind `real`, `integer` or `pattern` and the symmetries
`general`, `symmetric` and `skew-symmetric`. Symmetric matrices are stored with both triangles.

\param in the stream to read from
\param matrix receives the matrix; unchanged if reading fails
\param message receives one sentence that says what is wrong if reading fails

\return whether a matrix was read. All its entries are finite.
*/
inline bool read_matrix_market(std::istream& in, Eigen::SparseMatrix<double>& matrix, std::string& message)
{
  const auto fail = [&message](const std::string& text)
  {
    message = text;
    return false;
  };
  std::string line, banner, object, form, kind, symmetry;
  if(!std::getline(in, line))
    return fail("the file is empty");
  if(line.size() >= 2 && line[0] == '\x1f' && line[1] == '\x8b')
    return fail("the file is compressed by gzip; decompress it first");
  std::transform(line.begin(), line.end(), line.begin(), [](unsigned char c) { return std::tolower(c); });
  std::istringstream header(line);
  header >> banner >> object >> form >> kind >> symmetry;
  if(banner != "%%matrixmarket" || object != "matrix")
    return fail("the file does not begin with '%%MatrixMarket matrix'");
  const bool is_array = (form == "array");
  if(!is_array && form != "coordinate")
    return fail("the form '" + form + "' is not known");
  if(kind != "real" && kind != "integer" && kind != "double" && !(kind == "pattern" && !is_array))
    return fail("numbers of kind '" + kind + "' are not known");
  if(symmetry != "general" && symmetry != "symmetric" && symmetry != "skew-symmetric")
    return fail("the symmetry '" + symmetry + "' is not known");

  while(std::getline(in, line) && (line.empty() || line[0] == '%' || line == "\r"))
    ;
  std::istringstream sizes(line);
  long long rows = -1, columns = -1, entries = 0;
  sizes >> rows >> columns;
  if(!is_array)
    sizes >> entries;
  const long long largest = (std::numeric_limits<int>::max)();
  if(!sizes || rows < 0 || columns < 0 || entries < 0 || rows > largest || columns > largest || entries > largest)
    return fail("the line of sizes cannot be read");
  if(symmetry != "general" && rows != columns)
    return fail("a symmetric matrix must be square");

  std::vector<Eigen::Triplet<double>> triplets;
  const auto add = [&](long long i, long long j, double value)
  {
    triplets.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
    if(symmetry != "general" && i != j)
      triplets.emplace_back(static_cast<int>(j), static_cast<int>(i), symmetry == "symmetric" ? value : -value);
  };
  const auto read_value = [&](double& value) { return static_cast<bool>(in >> value) && std::isfinite(value); };
  if(is_array)
    for(long long j = 0; j < columns; ++j)
    {
      const long long first = symmetry == "general" ? 0 : (symmetry == "symmetric" ? j : j + 1);
      for(long long i = first; i < rows; ++i)
      {
        double value;
        if(!read_value(value))
          return fail("entry (" + std::to_string(i + 1) + ", " + std::to_string(j + 1) +
                      ") is missing or no finite number");
        if(value != 0.)
          add(i, j, value);
      }
    }
  else
    for(long long k = 0; k < entries; ++k)
    {
      long long i, j;
      double value = 1.;
      if(!(in >> i >> j) || (kind != "pattern" && !read_value(value)))
        return fail("entry " + std::to_string(k + 1) + " of " + std::to_string(entries) +
                    " is missing or no finite number");
      if(i < 1 || i > rows || j < 1 || j > columns)
        return fail("entry " + std::to_string(k + 1) + " lies outside of the matrix");
      add(i - 1, j - 1, value);
    }
  matrix.resize(rows, columns);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  matrix.makeCompressed();
  return true;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_READ_MATRIX_MARKET_H
