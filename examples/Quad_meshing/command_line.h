// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXAMPLES_COMMAND_LINE_H
#define CGAL_QUAD_MESHING_EXAMPLES_COMMAND_LINE_H

// What the command-line programs of this folder have in common: exit codes, options, reading and
// writing of meshes, a progress bar. A program looks like this:
//
//   int main(int argc, char* argv[])
//   {
//     return command_line::run("my_program", [&]
//     {
//       po::options_description options("Options");
//       options.add_options()("target-quads", po::value<double>()->default_value(4000), "number of quads");
//       command_line::Arguments args("my_program", "makes a mesh out of a mesh", { "IN", "OUT" }, options);
//       if(!args.parse(argc, argv))
//         return command_line::done;                 // --help
//       const auto tm = command_line::read_mesh<Mesh>(args.positional(0));
//       ...
//       command_line::write_mesh(args.positional(1), qm);
//       return command_line::done;
//     });
//   }
//
// Arguments and files that cannot be used throw `Unusable_input`, which `run()` turns into one line
// on the standard error stream and the exit code 2.

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/IO/Flat_json.h>
#include <CGAL/Quad_meshing/IO/read_polygon_soup.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>

#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>

#include <boost/any.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#ifndef _WIN32
#include <unistd.h>
#endif

namespace po = boost::program_options;

namespace command_line {

// The exit codes of all programs.
enum Exit_code
{
  done = 0,      // ran, and the result is valid
  not_valid = 1, // ran, but the result is not valid; the program says why
  unusable = 2   // the arguments or the input cannot be used; one line says why
};

// Arguments or a file that cannot be used; what() is the line for the user.
struct Unusable_input : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Text in one line.
inline std::string one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::replace(text.begin(), text.end(), '\r', ' ');
  return text;
}

// A number with the word for what is counted.
inline std::string count_of(std::size_t n, const std::string& singular, const std::string& plural)
{
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

// The version of the package, which the build knows.
inline const char* package_version()
{
#ifdef CGAL_QUAD_MESHING_VERSION
  return CGAL_QUAD_MESHING_VERSION;
#else
  return "of unknown version";
#endif
}

// Runs the body of a program and returns its exit code.
template <typename Body>
int run(const std::string& program, Body body)
{
  try
  {
    return body();
  }
  catch(const Unusable_input& e)
  {
    std::cerr << program << ": " << one_line(e.what()) << std::endl;
    return unusable;
  }
  catch(const po::error& e)
  {
    std::cerr << program << ": " << one_line(e.what()) << " (see --help)" << std::endl;
    return unusable;
  }
  catch(const std::bad_alloc&)
  {
    std::cerr << program << ": the memory does not suffice" << std::endl;
    return not_valid;
  }
  catch(const std::exception& e)
  {
    std::cerr << program << ": internal error: " << one_line(e.what()) << std::endl;
    return not_valid;
  }
}

// The command line of a program: positional arguments, its own options, and --help.
class Arguments
{
  std::string m_program, m_purpose;
  std::vector<std::string> m_names;
  po::options_description m_options;
  std::vector<std::string> m_positional;
  po::variables_map m_values;

public:
  // Names of positional arguments in brackets, as "[OUT]", may be left away by the user.
  Arguments(std::string program, std::string purpose, std::vector<std::string> names,
            const po::options_description& options)
    : m_program(std::move(program)), m_purpose(std::move(purpose)), m_names(std::move(names)), m_options(options)
  {
    m_options.add_options()("help,h", "show this text")("version", "show the version of the package");
  }

  // Returns false if the user asked for help or for the version, which was given.
  bool parse(int argc, const char* const* argv)
  {
    po::options_description hidden;
    hidden.add_options()("positional", po::value<std::vector<std::string>>());
    po::options_description all;
    all.add(m_options).add(hidden);
    po::positional_options_description positional;
    positional.add("positional", -1);

    // No guessing of abbreviated options: "--target" must not become "--target-quads" today and be
    // ambiguous tomorrow.
    namespace style = po::command_line_style;
    po::store(po::command_line_parser(argc, argv)
                .options(all)
                .positional(positional)
                .style(style::unix_style & ~style::allow_guessing)
                .run(),
              m_values);
    if(m_values.count("help"))
    {
      print_help(std::cout);
      return false;
    }
    if(m_values.count("version"))
    {
      std::cout << m_program << " " << package_version() << "\n";
      return false;
    }
    po::notify(m_values);
    if(m_values.count("positional"))
      m_positional = m_values["positional"].as<std::vector<std::string>>();

    const auto required = static_cast<std::size_t>(
      std::count_if(m_names.begin(), m_names.end(), [](const std::string& name) { return name[0] != '['; }));
    if(m_positional.size() < required)
      throw Unusable_input("the argument " + m_names[m_positional.size()] + " is missing (see --help)");
    if(m_positional.size() > m_names.size())
      throw Unusable_input("too many arguments: '" + m_positional[m_names.size()] + "' (see --help)");
    return true;
  }

  void print_help(std::ostream& os) const
  {
    os << "usage: " << m_program;
    for(const std::string& name : m_names)
      os << " " << name;
    os << " [options]\n"
       << m_purpose << "\n\n"
       << m_options << "\n"
       << "Exit code: 0 done and valid, 1 ran but the result is not valid, 2 unusable arguments or input.\n";
  }

  bool has(const std::string& option) const { return m_values.count(option) > 0 && !m_values[option].defaulted(); }

  bool has_positional(std::size_t i) const { return i < m_positional.size(); }
  const std::string& positional(std::size_t i) const { return m_positional.at(i); }

  // The value of an option that the user gave or that has a default value.
  template <typename T>
  const T& value(const std::string& option) const
  {
    return m_values[option].template as<T>();
  }

  // The same for a number that must be finite and lie in [low, high].
  double number(const std::string& option, double low, double high) const
  {
    const double x = value<double>(option);
    if(!(std::isfinite(x) && low <= x && x <= high))
      throw Unusable_input("--" + option + " must be a number from " + text(low) + " to " + text(high) + ", not " +
                           text(x));
    return x;
  }

  // The same for a number that must be finite and positive.
  double positive_number(const std::string& option) const
  {
    const double x = value<double>(option);
    if(!(std::isfinite(x) && x > 0))
      throw Unusable_input("--" + option + " must be a positive number, not " + text(x));
    return x;
  }

  // The same for a whole number in [low, high], which its option must have as `long long`: Boost takes -1 for a large
  // number where an unsigned one is expected.
  long long whole_number(const std::string& option, long long low, long long high) const
  {
    const long long n = value<long long>(option);
    if(n < low || n > high)
      throw Unusable_input("--" + option + " must be a whole number from " + std::to_string(low) + " to " +
                           std::to_string(high) + ", not " + std::to_string(n));
    return n;
  }

  // The number of threads: as many as anyone has cores at most.
  unsigned int number_of_threads(const std::string& option = "threads") const
  {
    constexpr long long most_threads = 4096;
    return static_cast<unsigned int>(whole_number(option, 1, most_threads));
  }

  // The seed of random numbers.
  unsigned int random_seed(const std::string& option = "seed") const
  {
    return static_cast<unsigned int>(whole_number(option, 0, (std::numeric_limits<unsigned int>::max)()));
  }

  // The position of the option's value in the list of words that are allowed.
  std::size_t choice(const std::string& option, const std::vector<std::string>& words) const
  {
    const std::string& word = value<std::string>(option);
    const auto found = std::find(words.begin(), words.end(), word);
    if(found != words.end())
      return static_cast<std::size_t>(found - words.begin());
    std::string list;
    for(const std::string& w : words)
      list += (list.empty() ? "" : ", ") + w;
    throw Unusable_input("--" + option + " must be one of " + list + ", not '" + word + "'");
  }

  // Whether an option of the kind --option on/off is on.
  bool is_on(const std::string& option) const { return choice(option, { "off", "on" }) == 1; }

  // All options with their values, those that have none left away.
  std::vector<std::pair<std::string, std::string>> values() const
  {
    std::vector<std::pair<std::string, std::string>> list;
    for(const auto& v : m_values)
    {
      const boost::any& any = v.second.value();
      if(const auto* word = boost::any_cast<std::string>(&any))
        list.emplace_back(v.first, *word);
      else if(const auto* number = boost::any_cast<double>(&any))
        list.emplace_back(v.first, text(*number));
      else if(const auto* whole = boost::any_cast<long long>(&any))
        list.emplace_back(v.first, std::to_string(*whole));
      else if(const auto* is_on = boost::any_cast<bool>(&any))
        list.emplace_back(v.first, *is_on ? "on" : "off");
      else if(any.empty())
        list.emplace_back(v.first, "on");
    }
    return list;
  }

private:
  static std::string text(double x)
  {
    std::ostringstream os;
    os << x;
    return os.str();
  }
};

// What programs let their users choose of greedy rounding.
struct Greedy_rounding
{
  double tolerance;
  int gauss_seidel, conjugate_gradient; // steps
  bool has_cholesky;
};

inline void add_greedy_rounding(po::options_description& options)
{
  options.add_options()("rounding-tolerance", po::value<double>()->default_value(3e-4, "3e-4"),
                        "accuracy of the levels of greedy rounding, in units of the variables")(
    "gauss-seidel", po::value<long long>()->default_value(20000), "local steps per greedy rounding, 0 for none")(
    "conjugate-gradient", po::value<long long>()->default_value(10),
    "steps of the conjugate gradient per greedy rounding, 0 for none")("no-cholesky", po::bool_switch(),
                                                                       "no new factorization between greedy roundings");
}

inline Greedy_rounding greedy_rounding(const Arguments& args)
{
  const long long most_steps = 1000000000;
  return Greedy_rounding{ args.number("rounding-tolerance", 0., 1.),
                          static_cast<int>(args.whole_number("gauss-seidel", 0, most_steps)),
                          static_cast<int>(args.whole_number("conjugate-gradient", 0, most_steps)),
                          !args.value<bool>("no-cholesky") };
}

// Reads a triangle mesh and says on the standard error stream, in one line, what was repaired. The result relates the
// elements of the mesh to those of the file.
template <typename Mesh>
Mesh read_mesh(const std::string& filename, CGAL::Quad_meshing::Mesh_reading_result& result)
{
  Mesh tm;
  result = CGAL::Quad_meshing::read_triangle_mesh(filename, tm);
  if(!result)
    throw Unusable_input(filename + ": " + result.message);
  std::string line;
  for(const std::string& repair : result.repairs)
    line += " " + repair;
  if(!line.empty())
    std::cerr << filename << ":" << line << "\n";
  return tm;
}

template <typename Mesh>
Mesh read_mesh(const std::string& filename)
{
  CGAL::Quad_meshing::Mesh_reading_result result;
  return read_mesh<Mesh>(filename, result);
}

// How messages name the vertices or faces of a mesh, `kind`: by their numbers in the file.
inline std::function<std::string(std::size_t)> names_in_file(const std::string& kind,
                                                             const CGAL::Quad_meshing::File_numbers& numbers)
{
  return [kind, numbers](std::size_t i)
  {
    const std::size_t n = numbers.file_number(i);
    return n == CGAL::Quad_meshing::File_numbers::none ? "a " + kind + " that the file does not have"
                                                       : kind + " " + std::to_string(n);
  };
}

// Reads points and polygons as they are in the file.
template <typename Point>
void read_soup(const std::string& filename, std::vector<Point>& points, std::vector<std::vector<std::size_t>>& polygons)
{
  const CGAL::Quad_meshing::Mesh_reading_result result =
    CGAL::Quad_meshing::read_polygon_soup(filename, points, polygons);
  if(!result)
    throw Unusable_input(filename + ": " + result.message);
}

inline std::ofstream open_output(const std::string& filename)
{
  errno = 0;
  std::ofstream out(filename, std::ios::out | std::ios::binary);
  if(!out)
    throw Unusable_input(filename + ": cannot be written: " + (errno != 0 ? std::strerror(errno) : "unknown reason"));
  out.precision(17);
  return out;
}

// Writes a file: `write` is given the stream.
template <typename Write>
void write_file(const std::string& filename, const Write& write)
{
  std::ofstream out = open_output(filename);
  write(out);
  out.close();
  if(!out)
    throw Unusable_input(filename + ": writing failed");
}

// Throws unless a file of that name can be written: to be asked before a long computation.
inline void check_output(const std::string& filename)
{
  // Appending opens the file without harm to what it may hold.
  errno = 0;
  const bool existed = static_cast<bool>(std::ifstream(filename));
  if(!std::ofstream(filename, std::ios::app))
    throw Unusable_input(filename + ": cannot be written: " + (errno != 0 ? std::strerror(errno) : "unknown reason"));
  if(!existed)
    std::remove(filename.c_str());
}

// The same for a file in one of some formats, told by the extension in lower case letters.
inline void check_output(const std::string& filename, const std::vector<std::string>& formats)
{
  const std::string extension = CGAL::Quad_meshing::internal::file_extension(filename);
  if(std::find(formats.begin(), formats.end(), extension) == formats.end())
  {
    std::string list;
    for(const std::string& format : formats)
      list += (list.empty() ? "" : ", ") + format;
    throw Unusable_input(filename + ": the format '" + extension + "' is not " + (formats.size() > 1 ? "one of " : "") +
                         list);
  }
  check_output(filename);
}

// The same for `write_mesh()`, which must know the format.
inline void check_mesh_output(const std::string& filename) { check_output(filename, { "off", "obj", "ply" }); }

// The digits of numbers in files that read back as they are.
constexpr int all_digits = std::numeric_limits<double>::max_digits10;

// Writes a mesh in the format that the extension names.
template <typename Mesh>
void write_mesh(const std::string& filename, const Mesh& mesh, int digits = all_digits)
{
  const std::string extension = CGAL::Quad_meshing::internal::file_extension(filename);
  check_mesh_output(filename);
  write_file(filename,
             [&](std::ostream& out)
             {
               out.precision(digits);
               const auto np = CGAL::parameters::stream_precision(digits);
               const bool written = extension == "off"   ? CGAL::IO::write_OFF(out, mesh, np)
                                    : extension == "obj" ? CGAL::IO::write_OBJ(out, mesh, np)
                                                         : CGAL::IO::write_PLY(out, mesh, np);
               if(!written)
                 out.setstate(std::ios::failbit);
             });
}

inline void write_json(const std::string& filename, const CGAL::Quad_meshing::Flat_json& json)
{
  write_file(filename, [&](std::ostream& out) { json.write(out); });
}

// A visitor that draws the running stage and how far it has come, on a terminal only.
class Progress_bar : public CGAL::Quad_meshing::Default_visitor
{
  static constexpr int width = 30;

  std::vector<std::string> m_stages;
  int m_drawn = -1;
  bool m_is_terminal;

public:
#ifdef _WIN32
  Progress_bar() : m_is_terminal(false) {}
#else
  Progress_bar() : m_is_terminal(isatty(STDERR_FILENO) == 1) {}
#endif

  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;
  ~Progress_bar() { erase(); }

  void on_stage_begin(const std::string& name)
  {
    m_stages.push_back(name);
    m_drawn = -1;
    progress(0);
  }

  void on_stage_end(const std::string&)
  {
    if(!m_stages.empty())
      m_stages.pop_back();
    erase();
  }

  void progress(double completed)
  {
    const int filled = static_cast<int>(width * (std::min)((std::max)(completed, 0.), 1.));
    if(!m_is_terminal || filled == m_drawn || m_stages.empty())
      return;
    m_drawn = filled;
    std::cerr << "\r\033[K[" << std::string(filled, '#') << std::string(width - filled, '.') << "] " << m_stages.back()
              << std::flush;
  }

private:
  void erase()
  {
    if(m_is_terminal)
      std::cerr << "\r\033[K" << std::flush;
    m_drawn = -1;
  }
};

} // namespace command_line

#endif // CGAL_QUAD_MESHING_EXAMPLES_COMMAND_LINE_H
