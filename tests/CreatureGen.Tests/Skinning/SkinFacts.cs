using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Skinning;

/// <summary>What is true of the weights of every creature, whoever solved them, and measures of bent skin.</summary>
internal static class SkinFacts
{
    /// <summary>The influences of a vertex that have weight.</summary>
    public static IEnumerable<(int Joint, float Weight)> Influences(this SkinWeights w)
    {
        yield return (w.Joint0, w.Weights.X);
        if (w.Weights.Y > 0f)
        {
            yield return (w.Joint1, w.Weights.Y);
        }

        if (w.Weights.Z > 0f)
        {
            yield return (w.Joint2, w.Weights.Z);
        }

        if (w.Weights.W > 0f)
        {
            yield return (w.Joint3, w.Weights.W);
        }
    }

    /// <summary>Weight of a joint in a vertex.</summary>
    public static float Of(this SkinWeights w, int joint) => w.Influences().Where(i => i.Joint == joint).Sum(i => i.Weight);

    /// <summary>Four joints at most, each once, in descending order, positive and exactly one together; unused slots are zero.</summary>
    public static void AreWellFormed(SkinWeights[] weights, Skeleton skeleton)
    {
        for (int v = 0; v < weights.Length; v++)
        {
            SkinWeights w = weights[v];
            Vector4 x = w.Weights;
            Assert.True(x.X >= x.Y && x.Y >= x.Z && x.Z >= x.W && x.W >= 0f, $"vertex {v}: {x}");
            Assert.Equal(1f, x.X + x.Y + x.Z + x.W);
            Assert.Equal(1f, x.W + x.Z + x.Y + x.X);
            int[] joints = w.Influences().Select(i => i.Joint).ToArray();
            Assert.Equal(joints.Length, joints.Distinct().Count());
            Assert.All(joints, j => Assert.True(j > 1 && j < skeleton.Count && skeleton.Joints[j].Role != JointRole.End, $"vertex {v} is moved by {skeleton.Joints[j].Name}"));
            Assert.True(x.Y > 0f || w.Joint1 == 0);
            Assert.True(x.Z > 0f || w.Joint2 == 0);
            Assert.True(x.W > 0f || w.Joint3 == 0);
        }
    }

    /// <summary>Mirrored vertices have mirrored joints with equal weights; vertices on the midline have symmetric ones.</summary>
    public static void AreMirrored(SkinWeights[] weights, RigSubject subject)
    {
        Surface surface = subject.Input.Surface;
        ReadOnlySpan<int> mirrors = subject.Skeleton.Mirrors;
        for (int v = 0; v < weights.Length; v++)
        {
            foreach ((int joint, float weight) in weights[v].Influences())
            {
                Assert.True(weights[surface.Mirror[v]].Of(mirrors[joint]) == weight, $"vertex {v}: {subject.Skeleton.Joints[joint].Name} {weight}");
            }
        }
    }

    /// <summary>No vertex is moved by a part of the creature that the surface does not connect it with.</summary>
    public static void DoNotLeak(SkinWeights[] weights, RigSubject subject)
    {
        RigInput input = subject.Input;
        Surface surface = input.Surface;
        int[] limbOf = LimbOfJoints(subject);
        int[][] near = Neighbourhoods(input);
        for (int v = 0; v < weights.Length; v++)
        {
            VertexAddress address = surface.Addresses[v];
            foreach ((int joint, float _) in weights[v].Influences())
            {
                int limb = limbOf[joint];
                string name = subject.Skeleton.Joints[joint].Name;
                if (address.Appendage >= 0)
                {
                    Assert.True(limb < 0 || limb == Key(input, address), $"a vertex of {Describe(input, address)} is moved by {name}");
                }
                else if (limb >= 0)
                {
                    Assert.True(near[v]?.Contains(limb) == true, $"vertex {v} of the body, more than two edges from its socket, is moved by {name}");
                }

                int bone = subject.Rig.Spine.BoneOf(joint);
                if (bone >= 0)
                {
                    int own = subject.Rig.Spine.BoneOf(subject.Rig.Spine.At(subject.Rig.Line.ArcAt(address.Ring)).Dominant);
                    Assert.True(Math.Abs(bone - own) <= 2 || address.Region == SurfaceRegion.Fin, $"vertex {v} at ring {address.Ring} is moved by {name}");
                }
            }
        }
    }

    /// <summary>Change of volume, and share of triangles that were turned inside out, when joints turn.</summary>
    public static (double Volume, double Inverted) Bend(RigSubject subject, SkinWeights[] weights, Func<Joint, Quaternion?> turn)
    {
        Vector3[] rest = subject.Input.Surface.Positions;
        int[] triangles = subject.Input.Surface.Triangles.ToArray();
        Vector3[] normals = Normals(rest, triangles);
        (Vector3[] moved, Vector3[] movedNormals) = subject.Bend(weights, normals, turn);
        int inverted = 0;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            inverted += !FacesBack(rest, normals, triangles, t) && FacesBack(moved, movedNormals, triangles, t) ? 1 : 0;
        }

        return ((Volume(moved, triangles) / Volume(rest, triangles)) - 1, inverted / (triangles.Length / 3.0));
    }

    public static Vector3[] Normals(Vector3[] positions, int[] triangles)
    {
        var normals = new Vector3[positions.Length];
        for (int t = 0; t < triangles.Length; t += 3)
        {
            Vector3 n = FaceNormal(positions, triangles, t);
            for (int k = 0; k < 3; k++)
            {
                normals[triangles[t + k]] += n;
            }
        }

        return Array.ConvertAll(normals, n => Vec.Normalize(n, Vector3.UnitY));
    }

    private static double Volume(Vector3[] positions, int[] triangles)
    {
        double six = 0;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            six += Vec.Dot(positions[triangles[t]], Vec.Cross(positions[triangles[t + 1]], positions[triangles[t + 2]]));
        }

        return six / 6;
    }

    private static bool FacesBack(Vector3[] positions, Vector3[] normals, int[] triangles, int t) =>
        Vec.Dot(FaceNormal(positions, triangles, t), normals[triangles[t]] + normals[triangles[t + 1]] + normals[triangles[t + 2]]) < 0f;

    private static Vector3 FaceNormal(Vector3[] positions, int[] triangles, int t) =>
        Vec.Cross(positions[triangles[t + 1]] - positions[triangles[t]], positions[triangles[t + 2]] - positions[triangles[t]]);

    /// <summary>Number of a limb: those on the right are odd; a fin on the midline is one limb.</summary>
    private static int Key(RigInput input, in VertexAddress address) => (2 * address.Appendage) + (address.Sign < 0 && input.Appendages[address.Appendage].Paired ? 1 : 0);

    private static string Describe(RigInput input, in VertexAddress address) => $"{input.Appendages[address.Appendage].Kind} {input.Appendages[address.Appendage].Pair} ({address.Sign})";

    private static int[] LimbOfJoints(RigSubject subject)
    {
        int[] limbs = new int[subject.Skeleton.Count];
        Array.Fill(limbs, -1);
        for (int a = 0; a < subject.Rig.Appendages.Count; a++)
        {
            foreach (int j in subject.Rig.Appendages[a].Left)
            {
                limbs[j] = 2 * a;
            }

            foreach (int j in subject.Rig.Appendages[a].Right)
            {
                limbs[j] = (2 * a) + 1;
            }
        }

        return limbs;
    }

    /// <summary>For each vertex of the body, the limbs whose skin begins at most three edges away: found by walking, vertex by vertex.</summary>
    private static int[][] Neighbourhoods(RigInput input)
    {
        Surface surface = input.Surface;
        var near = new int[surface.Positions.Length][];
        for (int v = 0; v < near.Length; v++)
        {
            if (surface.Addresses[v].Appendage >= 0)
            {
                continue;
            }

            var seen = new HashSet<int> { v };
            var front = new List<int> { v };
            var limbs = new HashSet<int>();
            for (int step = 0; step < SocketSpread.Rings; step++)
            {
                var next = new List<int>();
                foreach (int f in front)
                {
                    foreach (int n in input.Adjacency.Of(f))
                    {
                        if (surface.Addresses[n].Appendage >= 0)
                        {
                            limbs.Add(Key(input, surface.Addresses[n]));
                        }
                        else if (seen.Add(n))
                        {
                            next.Add(n);
                        }
                    }
                }

                front = next;
            }

            near[v] = limbs.ToArray();
        }

        return near;
    }
}
