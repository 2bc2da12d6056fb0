// SPDX-License-Identifier: MIT
// glTF files that a test makes from numbers.
#ifndef SHD_TESTS_SUPPORT_GLTF_FILE_H
#define SHD_TESTS_SUPPORT_GLTF_FILE_H

#include <cstdint>
#include <string>
#include <vector>

namespace shd_test
{

inline int gltf_type(int8_t) { return 5120; }
inline int gltf_type(uint8_t) { return 5121; }
inline int gltf_type(int16_t) { return 5122; }
inline int gltf_type(uint16_t) { return 5123; }
inline int gltf_type(uint32_t) { return 5125; }
inline int gltf_type(float) { return 5126; }

inline std::string base64(const std::string &bytes)
{
    static const char k_digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; ++k) {
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : k_digits[bits >> (18 - 6 * k) & 63];
    }
    return out;
}

/// One buffer with a view and an accessor for each column, and other members of the file as text.
class GltfFile
{
   public:
    std::string members;  // further members of the file, each with a comma before it
    std::string uri;      // URI of the buffer; an empty one becomes "data:"

    int view(const std::string &bytes, const std::string &more = "")
    {
        while (bytes_.size() % 4) bytes_ += '\0';
        views_ += (view_count_ ? "," : "") + std::string("{\"buffer\":0,\"byteOffset\":") +
                  std::to_string(bytes_.size()) + ",\"byteLength\":" + std::to_string(bytes.size()) + more + "}";
        bytes_ += bytes;
        return view_count_++;
    }
    int raw_view(const std::string &json)
    {
        views_ += (view_count_ ? "," : "") + json;
        return view_count_++;
    }
    int accessor(int view, int component_type, size_t count, const std::string &type, const std::string &more = "")
    {
        accessors_ += (accessor_count_ ? "," : "") + std::string("{") +
                      (view < 0 ? "" : "\"bufferView\":" + std::to_string(view) + ",") +
                      "\"componentType\":" + std::to_string(component_type) + ",\"count\":" + std::to_string(count) +
                      ",\"type\":\"" + type + "\"" + more + "}";
        return accessor_count_++;
    }
    template <class T>
    static std::string bytes_of(const std::vector<T> &numbers)
    {
        return std::string(reinterpret_cast<const char *>(numbers.data()), numbers.size() * sizeof(T));
    }
    /// A column with elements of `width` numbers, packed; elements of other sizes than 4 bytes have a stride.
    template <class T>
    int column(const std::vector<T> &numbers, size_t width, bool normalized = false)
    {
        static const char *const k_types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        const size_t size = width * sizeof(T), stride = width == 1 ? size : (size + 3) / 4 * 4;
        std::string bytes;
        for (size_t i = 0; i < numbers.size(); i += width) {
            bytes.append(reinterpret_cast<const char *>(&numbers[i]), size);
            bytes.append(stride - size, '\x7f');
        }
        const std::string more = stride == size ? "" : ",\"byteStride\":" + std::to_string(stride);
        return accessor(view(bytes, more), gltf_type(T()), numbers.size() / width,
                        width == 16 ? "MAT4" : k_types[width], normalized ? ",\"normalized\":true" : "");
    }
    /// Corners (0 0), (1 0), (1 1), (0 1) in the plane z = 0.
    int square() { return column<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3); }
    int square_indices() { return column<uint16_t>({0, 1, 2, 0, 2, 3}, 1); }

    const std::string &bytes() const { return bytes_; }
    std::string text() const
    {
        return "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":" + std::to_string(bytes_.size()) +
               (uri == "none"
                    ? ""
                    : ",\"uri\":\"" + (uri.empty() ? "data:application/octet-stream;base64," + base64(bytes_) : uri) +
                          "\"") +
               "}" + more_buffers + "],\"bufferViews\":[" + views_ + "],\"accessors\":[" + accessors_ + "]" + members +
               "}";
    }
    /// A file of one mesh at a node, whose primitive has these members.
    std::string with_primitive(const std::string &primitive, const std::string &more = "")
    {
        members +=
            ",\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"name\":\"m\","
            "\"primitives\":[{" +
            primitive + "}]}]" + more;
        return text();
    }
    std::string glb()
    {
        uri = "none";
        std::string json = text(), binary = bytes_;
        while (json.size() % 4) json += ' ';
        while (binary.size() % 4) binary += '\0';
        const auto word = [](size_t value) {
            const auto v = static_cast<uint32_t>(value);
            return std::string(reinterpret_cast<const char *>(&v), 4);
        };
        return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" + json +
               word(binary.size()) + std::string("BIN\0", 4) + binary;
    }
    std::string more_buffers;  // each with a comma before it

   private:
    std::string bytes_, views_, accessors_;
    int view_count_ = 0, accessor_count_ = 0;
};

}  // namespace shd_test

#endif  // SHD_TESTS_SUPPORT_GLTF_FILE_H
