// What urdfdom makes of a robot, as JSON.
#include <urdf_parser/urdf_parser.h>
#ifdef WITH_KDL
#include <kdl_parser/kdl_parser.hpp>
#endif
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>

static std::string quoted(const std::string &text) {
  std::string out = "\"";
  for (unsigned char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c >= 32) out += static_cast<char>(c);
  }
  return out + "\"";
}

static std::string number(double value) {
  if (!std::isfinite(value)) return "null";
  std::ostringstream out;
  out.precision(12);
  out << value;
  return out.str();
}

int main(int argc, char **argv) {
  if (argc != 2) return 2;
  std::ifstream file(argv[1]);
  std::stringstream text;
  text << file.rdbuf();
  urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(text.str());
  if (!robot) {
    std::cerr << "not loaded\n";
    return 1;
  }
#ifdef WITH_KDL
  KDL::Tree tree;
  if (!kdl_parser::treeFromUrdfModel(*robot, tree)) {
    std::cerr << "no KDL tree\n";
    return 1;
  }
#endif
  std::ostringstream links, joints;
  int bodies = 0;
  for (const auto &entry : robot->links_) {
    double mass = entry.second->inertial ? entry.second->inertial->mass : 0;
#ifdef WITH_KDL
    const auto segment = tree.getSegments().find(entry.first);
    mass = segment == tree.getSegments().end() ? 0 : GetTreeElementSegment(segment->second).getInertia().getMass();
#endif
    links << (links.tellp() > 0 ? ", " : "") << quoted(entry.first) << ": "
          << (entry.second->inertial ? number(mass) : "null");
    bodies += entry.second->visual_array.size() + entry.second->collision_array.size();
  }
  const char *kinds[] = {"unknown", "revolute", "continuous", "prismatic", "floating", "planar", "fixed"};
  for (const auto &entry : robot->joints_) {
    const auto &joint = *entry.second;
    joints << (joints.tellp() > 0 ? ", " : "") << quoted(entry.first) << ": [\"" << kinds[joint.type] << "\", "
           << (joint.limits ? number(joint.limits->lower) : "null") << ", "
           << (joint.limits ? number(joint.limits->upper) : "null") << "]";
  }
  std::cout << "{\"links\": {" << links.str() << "}, \"joints\": {" << joints.str() << "}, \"bodies\": " << bodies
            << "}\n";
}
