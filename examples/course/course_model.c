/* SPDX-License-Identifier: MIT */
#include "course.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef EXAMPLE_HAS_ASSIMP
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#endif

enum { AROUND = 96, DOWN = 48 };

static int allocate(struct course_model *model, size_t vertex_count, size_t index_count)
{
    model->vertex_count = (uint32_t)vertex_count;
    model->index_count = index_count;
    model->position = (float *)malloc(vertex_count * 3 * sizeof(float));
    model->normal = (float *)malloc(vertex_count * 3 * sizeof(float));
    model->uv = (float *)calloc(vertex_count * 2, sizeof(float));
    model->indices = (uint32_t *)malloc(index_count * sizeof(uint32_t));
    return model->position && model->normal && model->uv && model->indices;
}

void course_model_release(struct course_model *model)
{
    free(model->position), free(model->normal), free(model->uv), free(model->indices);
}

/* Counter-clockwise as seen from outside. */
static int make_sphere(struct course_model *model)
{
    const float pi = 3.14159265f;
    uint32_t i, j, *index;
    if (!allocate(model, (AROUND + 1) * (DOWN + 1), AROUND * DOWN * 6)) return 0;
    index = model->indices;
    for (j = 0; j <= DOWN; ++j) {
        for (i = 0; i <= AROUND; ++i) {
            const size_t vertex = j * (AROUND + 1) + i;
            const float across = 2.0f * pi * (float)i / AROUND, down = pi * (float)j / DOWN;
            float *n = model->normal + 3 * vertex;
            n[0] = sinf(down) * sinf(across), n[1] = cosf(down), n[2] = sinf(down) * cosf(across);
            memcpy(model->position + 3 * vertex, n, 3 * sizeof *n);
            model->uv[2 * vertex] = (float)i / AROUND, model->uv[2 * vertex + 1] = (float)j / DOWN;
        }
    }
    for (j = 0; j < DOWN; ++j) {
        for (i = 0; i < AROUND; ++i) {
            const uint32_t a = j * (AROUND + 1) + i, b = a + AROUND + 1;
            *index++ = a, *index++ = b, *index++ = b + 1;
            *index++ = a, *index++ = b + 1, *index++ = a + 1;
        }
    }
    return 1;
}

#ifdef EXAMPLE_HAS_ASSIMP
/* Finds the diffuse texture of the first mesh that has one, beside the model. Skips embedded textures. */
static void find_texture(const struct aiScene *scene, const char *path, struct course_model *model)
{
    const char *slash = strrchr(path, '/');
    const int folder = slash ? (int)(slash - path + 1) : 0;
    unsigned i;
    for (i = 0; i < scene->mNumMaterials && !*model->texture; ++i) {
        struct aiString name;
        if (aiGetMaterialTexture(scene->mMaterials[i], aiTextureType_DIFFUSE, 0, &name, NULL, NULL, NULL, NULL, NULL,
                                 NULL) != AI_SUCCESS ||
            name.data[0] == '*') {
            continue;
        }
        snprintf(model->texture, sizeof model->texture, "%.*s%s", folder, path, name.data);
        while ((slash = strchr(model->texture, '\\'))) model->texture[slash - model->texture] = '/';
    }
}

/* Copies all triangles of the scene into one mesh. */
static int copy_scene(const struct aiScene *scene, struct course_model *model)
{
    size_t vertices = 0, faces = 0;
    unsigned i, k;
    uint32_t base = 0, *index;
    for (i = 0; i < scene->mNumMeshes; ++i) {
        vertices += scene->mMeshes[i]->mNumVertices, faces += scene->mMeshes[i]->mNumFaces;
    }
    if (vertices == 0 || vertices > 1u << 28 || !allocate(model, vertices, 3 * faces)) return 0;
    index = model->indices;
    for (i = 0; i < scene->mNumMeshes; ++i) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        if (!mesh->mNormals) return 0;
        for (k = 0; k < mesh->mNumVertices; ++k) {
            const struct aiVector3D *p = &mesh->mVertices[k], *n = &mesh->mNormals[k];
            float *position = model->position + 3 * (base + k), *normal = model->normal + 3 * (base + k);
            position[0] = p->x, position[1] = p->y, position[2] = p->z;
            normal[0] = n->x, normal[1] = n->y, normal[2] = n->z;
            if (!mesh->mTextureCoords[0]) continue;
            model->uv[2 * (base + k)] = mesh->mTextureCoords[0][k].x;
            model->uv[2 * (base + k) + 1] = 1.0f - mesh->mTextureCoords[0][k].y; /* assimp's v is up */
        }
        for (k = 0; k < mesh->mNumFaces; ++k) {
            const struct aiFace *face = &mesh->mFaces[k];
            if (face->mNumIndices != 3) continue; /* points and lines */
            *index++ = base + face->mIndices[0], *index++ = base + face->mIndices[1],
            *index++ = base + face->mIndices[2];
        }
        base += mesh->mNumVertices;
    }
    model->index_count = (size_t)(index - model->indices);
    return 1;
}

static int load(const char *path, struct course_model *model)
{
    const struct aiScene *scene = aiImportFile(path, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                                         aiProcess_PreTransformVertices | aiProcess_GenSmoothNormals);
    int good = scene && copy_scene(scene, model);
    if (good) find_texture(scene, path, model);
    aiReleaseImport(scene);
    return good;
}

const char *course_default_model(int relief)
{
    const char *path = relief ? "/usr/share/assimp/models/OBJ/spider.obj" : "/usr/share/assimp/models/Collada/duck.dae";
    FILE *file = fopen(path, "rb");
    if (!file) return "-";
    fclose(file);
    return path;
}
#else
static int load(const char *path, struct course_model *model)
{
    (void)path, (void)model;
    return 0;
}

const char *course_default_model(int relief)
{
    (void)relief;
    return "-";
}
#endif

int course_model_create(const char *path, struct course_model *model)
{
    return strcmp(path, "-") == 0 ? make_sphere(model) : load(path, model);
}
