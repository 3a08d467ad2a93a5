#include <fstream>
#include <sstream>
#include <stdexcept>

#include "solver/model/fields.h"
#include "solver/results/dataset.h"
#include "solver/results/durable.h"
#include "solver/results/results.h"

namespace trajan::results {

namespace {

/// One component of the rows of a dataset in /VTKHDF, as XDMF's hyperslab: start, stride and count.
struct Slab {
  std::string dataset;
  hsize_t rows;        ///< of the whole dataset
  hsize_t components;  ///< of the whole dataset; 0: one-dimensional
  hsize_t first_row;
  hsize_t count;
  hsize_t first_component;
  hsize_t component_count;
};

void write_slab(std::ostream& out, const std::string& file, const Slab& slab) {
  const bool table = slab.components > 0;
  const auto pair = [&](hsize_t row, hsize_t component) {
    std::string text = std::to_string(row);
    return table ? text.append(" ").append(std::to_string(component)) : text;
  };
  out << "<DataItem ItemType=\"HyperSlab\" Dimensions=\"" << pair(slab.count, slab.component_count)
      << "\"><DataItem Format=\"XML\" Dimensions=\"3 " << (table ? 2 : 1) << "\">"
      << pair(slab.first_row, slab.first_component) << " " << pair(1, 1) << " "
      << pair(slab.count, slab.component_count) << "</DataItem><DataItem Format=\"HDF\" NumberType=\""
      << (slab.dataset == "PointData/body" || slab.dataset == "PointData/particle_number" ? "Int" : "Float")
      << "\" Precision=\"" << (slab.dataset == "PointData/body" ? 4 : 8) << "\" Dimensions=\""
      << pair(slab.rows, slab.components) << "\">" << file << ":/VTKHDF/" << slab.dataset
      << "</DataItem></DataItem>";
}

/// What the grids of all times share.
struct Source {
  std::string file;
  Handle vtk;
  hsize_t particles;
};

void write_attribute(std::ostream& out, const Source& source, const std::string& name, const char* type,
                     const Slab& slab) {
  out << "<Attribute Name=\"" << name << "\" AttributeType=\"" << type << "\" Center=\"Node\">";
  write_slab(out, source.file, slab);
  out << "</Attribute>\n";
}

/// Vectors stay vectors. Tensors become scalars: readers disagree about the order of a tensor.
void write_field(std::ostream& out, const Source& source, const std::string& name, hsize_t step) {
  const std::string path = "PointData/" + name;
  const Dataset data = Dataset::open(source.vtk, path, Dataset::Checksums::verify);
  const hsize_t n = source.particles;
  if (data.components() == 0) {
    const bool constant = name == "body" || name == "particle_number";
    return write_attribute(out, source, name, "Scalar", {path, data.rows(), 0, constant ? 0 : step * n, n, 0, 0});
  }
  if (data.components() == 3)
    return write_attribute(out, source, name, "Vector", {path, data.rows(), 3, step * n, n, 0, 3});
  const Field any_tensor = data.components() == 9 ? Field::deformation_gradient : Field::stress;
  const auto components = field_components(any_tensor, Dimension::solid);
  for (hsize_t c = 0; c < components.size(); ++c)
    write_attribute(out, source, std::string(name).append("_").append(components[c]), "Scalar",
                    {path, data.rows(), data.components(), step * n, n, c, 1});
}

std::vector<std::string> field_names(hid_t vtk) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  const Handle group = open_group(vtk, "PointData");
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names), "list the fields");
  return names;
}

void write_grids(std::ostream& out, const Source& source) {
  const Dataset points = Dataset::open(source.vtk, "Points", Dataset::Checksums::verify);
  const Dataset times = Dataset::open(source.vtk, "Steps/Values", Dataset::Checksums::verify);
  std::vector<double> values(times.rows());
  times.read<double>(0, values);
  const hsize_t n = source.particles;
  for (hsize_t step = 0; step < values.size(); ++step) {
    out << "<Grid Name=\"particles\" GridType=\"Uniform\">\n<Time Value=\"" << values[step]
        << "\"/>\n<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"" << n << "\" NodesPerElement=\"1\"/>\n"
        << "<Geometry GeometryType=\"XYZ\">";
    write_slab(out, source.file, {"Points", points.rows(), 3, step * n, n, 0, 3});
    out << "</Geometry>\n";
    for (const std::string& name : field_names(source.vtk)) write_field(out, source, name, step);
    out << "</Grid>\n";
  }
}

std::string describe(const std::filesystem::path& result_file) {
  std::ostringstream out;
  out.precision(17);
  out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
      << "<Grid Name=\"snapshots\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  const Handle file = open_file(result_file, Access::read_closed);
  const htri_t has_snapshots = H5Lexists(file, "VTKHDF", H5P_DEFAULT);
  check(has_snapshots, "look for snapshots");
  if (has_snapshots) {
    Source source{result_file.filename().string(), open_group(file, "VTKHDF"), 0};
    source.particles = Dataset::open(source.vtk, "PointData/body", Dataset::Checksums::verify).rows();
    write_grids(out, source);
  }
  out << "</Grid>\n</Domain>\n</Xdmf>\n";
  return out.str();
}

}  // namespace

std::filesystem::path write_xdmf(const std::filesystem::path& result_file) {
  silence_hdf5();
  const std::filesystem::path path = result_file.parent_path() / xdmf_name;
  const std::filesystem::path unfinished = path.string() + ".part";
  try {
    std::ofstream out(unfinished, std::ios::trunc);
    out << describe(result_file);
    out.close();
    if (!out) throw std::runtime_error("cannot write it");
    publish(unfinished, path);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
  return path;
}

}  // namespace trajan::results
