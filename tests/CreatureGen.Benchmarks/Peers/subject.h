// What the probe of the benchmarks writes for its peers with "export": one file a creature, numbers of the machine's own byte order.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Subject {
  std::vector<int32_t> parents;
  // Per joint: translation x y z, rotation x y z w, in the parent's space.
  std::vector<float> first, second;
  // Per joint 16 numbers, column by column.
  std::vector<float> matrices;
  // Per vertex: 3, 3, 4 and 3 numbers; the fourth weight is what is left to 1.
  std::vector<float> positions, normals;
  std::vector<uint16_t> joints;
  std::vector<float> weights;
  std::vector<uint32_t> triangles;

  size_t Joints() const { return parents.size(); }
  size_t Vertices() const { return positions.size() / 3; }

  static Subject Read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(path + " cannot be opened");
    Subject s;
    const size_t joints = Count(file);
    s.parents = Values<int32_t>(file, joints);
    s.first = Values<float>(file, joints * 7);
    s.second = Values<float>(file, joints * 7);
    s.matrices = Values<float>(file, joints * 16);
    const size_t vertices = Count(file);
    s.positions = Values<float>(file, vertices * 3);
    s.normals = Values<float>(file, vertices * 3);
    s.joints = Values<uint16_t>(file, vertices * 4);
    s.weights = Values<float>(file, vertices * 3);
    s.triangles = Values<uint32_t>(file, Count(file));
    return s;
  }

  static std::vector<Subject> ReadAll(const std::string& folder) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".subject") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    std::vector<Subject> all;
    for (const auto& path : paths) all.push_back(Read(path));
    return all;
  }

 private:
  static size_t Count(std::ifstream& file) { return Values<int32_t>(file, 1)[0]; }

  template <class T>
  static std::vector<T> Values(std::ifstream& file, size_t count) {
    std::vector<T> values(count);
    file.read(reinterpret_cast<char*>(values.data()), count * sizeof(T));
    if (!file) throw std::runtime_error("a subject's file is too short");
    return values;
  }
};

// Work on some items, each done and timed alone; `operations` is how many operations an item is, of which one is told.
struct Row {
  std::vector<std::function<void()>> items;
  int operations = 1;
};

// Obeys the same lines as the probe: "read FOLDER" and "round ROW", answered with the nanoseconds of an operation of each item.
inline int Obey(const std::function<void(const std::string&)>& read, const std::function<Row(const std::string&)>& make) {
  std::map<std::string, Row> rows;
  for (std::string line; std::getline(std::cin, line) && !line.empty();) {
    std::istringstream words(line);
    std::string verb, name;
    words >> verb >> name;
    if (verb == "read") {
      read(name);
      std::cout << "read" << std::endl;
      continue;
    }
    if (verb != "round") {
      std::cerr << "'" << line << "'; expected read or round\n";
      return 2;
    }
    auto found = rows.find(name);
    if (found == rows.end()) found = rows.emplace(name, make(name)).first;
    std::ostringstream answer;
    for (const auto& item : found->second.items) {
      const auto start = std::chrono::steady_clock::now();
      item();
      const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
      answer << (answer.tellp() > 0 ? " " : "") << taken.count() / found->second.operations;
    }
    std::cout << answer.str() << std::endl;
  }
  return 0;
}
