// SPDX-License-Identifier: MIT
// Models that are read from texts and bytes of a test.
#ifndef SHD_TESTS_SUPPORT_SCENE_MODEL_H
#define SHD_TESTS_SUPPORT_SCENE_MODEL_H

#include <map>
#include <string>

#include "scene/read/read.h"

namespace shd_test
{

/// Files of a test by name.
class MapFiles : public shd::scene::Files
{
   public:
    explicit MapFiles(const std::map<std::string, std::string> &files)
    {
        for (const auto &[name, text] : files) add(name, text);
    }
    const shd::scene::Bytes *find(const std::string &name) override
    {
        const auto at = files_.find(name);
        return at == files_.end() ? nullptr : &at->second.bytes;
    }

   private:
    struct File {
        std::string text;
        shd::scene::Bytes bytes;
    };
    void add(const std::string &name, const std::string &text)
    {
        File &file = files_[name];
        file.text = text;
        file.bytes = {reinterpret_cast<const unsigned char *>(file.text.data()), file.text.size()};
    }
    std::map<std::string, File> files_;
};

inline shd::scene::Model read_text(const std::string &text, const std::string &name = "model",
                                   const std::map<std::string, std::string> &files = {},
                                   const shd::scene::Limits &limits = {})
{
    MapFiles around(files);
    const shd::scene::Deadline deadline(limits.seconds);
    const shd::scene::Bytes bytes = {reinterpret_cast<const unsigned char *>(text.data()), text.size()};
    return shd::scene::read_model({bytes, name, around, limits, deadline});
}

/// The warnings, each with a line end.
inline std::string warnings_of(const shd::scene::Model &model)
{
    std::string all;
    for (const std::string &warning : model.warnings) all += warning + "\n";
    return all;
}

inline bool has_warning(const shd::scene::Model &model, const char *part)
{
    return warnings_of(model).find(part) != std::string::npos;
}

/// Area of all triangles, times their normal's z.
inline double area_of(const shd::scene::Model &model)
{
    double sum = 0;
    for (const shd::scene::Geometry &g : model.geometries) {
        for (size_t i = 0; i < g.indices.size(); i += 3) {
            const float *a = &g.position[3 * g.indices[i]], *b = &g.position[3 * g.indices[i + 1]],
                        *c = &g.position[3 * g.indices[i + 2]];
            sum += 0.5 * (double(b[0] - a[0]) * double(c[1] - a[1]) - double(b[1] - a[1]) * double(c[0] - a[0]));
        }
    }
    return sum;
}

}  // namespace shd_test

#endif  // SHD_TESTS_SUPPORT_SCENE_MODEL_H
