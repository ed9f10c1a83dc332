using System;
using CreatureGen.Creatures;
using CreatureGen.Engines;
using UnityEngine;
using UnityEngine.Rendering;

namespace CreatureGen.Unity
{
    /// <summary>Meshes and textures of creatures as Unity has them.</summary>
    public static class CreatureMeshes
    {
        /// <summary>The skinned mesh; a sub-mesh for each material of the creature.</summary>
        public static Mesh Skinned(Creature creature)
        {
            CreatureMesh textured = creature.Mesh.Textured();
            EngineMesh source = textured.For(EngineAxes.Unity);
            int count = source.VertexCount;
            var positions = new System.Numerics.Vector3[count];
            var normals = new System.Numerics.Vector3[count];
            var tangents = new System.Numerics.Vector4[count];
            var texcoords = new System.Numerics.Vector2[count];
            var colours = new System.Numerics.Vector4[count];
            var joints = new ushort[4 * count];
            var weights = new System.Numerics.Vector4[count];
            var indices = new int[source.IndexCount];
            source.FillPositions(positions);
            source.FillNormals(normals);
            source.FillTangents(tangents);
            source.FillTexcoords(texcoords);
            source.FillColours(colours);
            for (int i = 0; i < count; i++)
            {
                // What the atlas paints is white; eyes, claws and teeth lie on white texels and keep their colours.
                colours[i] = CreatureTextures.KeepsItsColour(textured.Texcoords[i]) ? colours[i] : System.Numerics.Vector4.One;
            }

            source.FillInfluences(joints, weights);
            source.FillIndices(indices);

            var mesh = new Mesh { name = "creature " + creature.Blueprint.Seed, indexFormat = source.FitsShortIndices ? IndexFormat.UInt16 : IndexFormat.UInt32 };
            mesh.vertices = Array.ConvertAll(positions, v => new Vector3(v.X, v.Y, v.Z));
            mesh.normals = Array.ConvertAll(normals, v => new Vector3(v.X, v.Y, v.Z));
            mesh.tangents = Array.ConvertAll(tangents, v => new Vector4(v.X, v.Y, v.Z, v.W));
            mesh.uv = Array.ConvertAll(texcoords, v => new Vector2(v.X, v.Y));
            mesh.colors = Array.ConvertAll(colours, v => new Color(v.X, v.Y, v.Z, v.W));
            var bones = new BoneWeight[count];
            for (int i = 0; i < count; i++)
            {
                bones[i] = new BoneWeight
                {
                    boneIndex0 = joints[4 * i], weight0 = weights[i].X,
                    boneIndex1 = joints[(4 * i) + 1], weight1 = weights[i].Y,
                    boneIndex2 = joints[(4 * i) + 2], weight2 = weights[i].Z,
                    boneIndex3 = joints[(4 * i) + 3], weight3 = weights[i].W,
                };
            }

            mesh.boneWeights = bones;
            var binds = new System.Numerics.Matrix4x4[creature.Skeleton.Count];
            creature.Skeleton.For(EngineAxes.Unity).FillInverseBinds(binds);
            mesh.bindposes = Array.ConvertAll(binds, m => UnitySpace.Matrix(m));
            mesh.subMeshCount = source.Parts.Count;
            for (int part = 0; part < source.Parts.Count; part++)
            {
                mesh.SetTriangles(indices.AsSpan(source.Parts[part].FirstIndex, source.Parts[part].IndexCount).ToArray(), part);
            }

            mesh.RecalculateBounds();
            return mesh;
        }

        /// <summary>The base colour of its skin. Unity's rows begin at the bottom.</summary>
        public static Texture2D BaseColour(Creature creature, int size)
        {
            CreatureTextures atlas = CreatureTextures.Bake(creature, size);
            var turned = new byte[3 * size * size];
            for (int row = 0; row < size; row++)
            {
                atlas.BaseColour.Slice(3 * size * (size - 1 - row), 3 * size).CopyTo(turned.AsSpan(3 * size * row));
            }

            var texture = new Texture2D(size, size, TextureFormat.RGB24, false);
            texture.LoadRawTextureData(turned);
            texture.Apply();
            return texture;
        }
    }
}
