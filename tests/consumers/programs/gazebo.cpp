// What libsdformat, by which Gazebo reads URDF, makes of a robot, as JSON.
#include <sdf/sdf.hh>
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
  if (!std::isfinite(value) || std::abs(value) > 1e15) return "null";
  std::ostringstream out;
  out.precision(12);
  out << value;
  return out.str();
}

int main(int argc, char **argv) {
  if (argc != 2) return 2;
  sdf::Root root;
  const sdf::Errors errors = root.Load(argv[1]);
  const sdf::Model *model = root.Model();
  if (!errors.empty() || model == nullptr) {
    std::cerr << (errors.empty() ? "no model" : errors.front().Message()) << "\n";
    return 1;
  }
  std::ostringstream links, joints;
  std::uint64_t bodies = 0;
  for (std::uint64_t n = 0; n < model->LinkCount(); ++n) {
    const sdf::Link &link = *model->LinkByIndex(n);
    links << (n > 0 ? ", " : "") << quoted(link.Name()) << ": " << number(link.Inertial().MassMatrix().Mass());
    bodies += link.VisualCount() + link.CollisionCount();
  }
  for (std::uint64_t n = 0; n < model->JointCount(); ++n) {
    const sdf::Joint &joint = *model->JointByIndex(n);
    const sdf::JointAxis *axis = joint.Axis(0);
    joints << (n > 0 ? ", " : "") << quoted(joint.Name()) << ": [\"" << static_cast<int>(joint.Type()) << "\", "
           << (axis ? number(axis->Lower()) : "null") << ", " << (axis ? number(axis->Upper()) : "null") << "]";
  }
  std::cout << "{\"links\": {" << links.str() << "}, \"joints\": {" << joints.str() << "}, \"bodies\": " << bodies
            << "}\n";
}
