using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Json;
using CreatureGen.Maths;
using CreatureGen.Skinning;

namespace CreatureGen.Gltf.Models;

/// <summary>All skinned triangles of a document as one mesh, and the places at which its joints were bound.</summary>
internal sealed class ModelSkin
{
    /// <summary>Most vertices of a model.</summary>
    private const int MaxVertices = 1 << 22;

    /// <summary>Most by which two skins may bind a joint apart: rounding. Metres and parts of a unit quaternion.</summary>
    private const float Apart = 1e-3f;

    private readonly ModelDocument document;
    private readonly ModelJoints joints;
    private readonly AccessorReader accessors;
    private readonly Quaternion[] rotations;
    private readonly Vector3[] places;
    private readonly bool[] bound;
    private readonly List<Vector3> positions = new();
    private readonly List<Vector3> normals = new();
    private readonly List<SkinWeights> weights = new();
    private readonly List<int> triangles = new();

    private ModelSkin(ModelDocument document, ModelJoints joints)
    {
        this.document = document;
        this.joints = joints;
        accessors = new AccessorReader(document);
        rotations = joints.Skeleton.ModelRotations.ToArray();
        places = joints.Skeleton.ModelPositions.ToArray();
        bound = new bool[rotations.Length];
    }

    /// <summary>Rotation of each joint where it was bound; the rest pose of joints that no skin names.</summary>
    public Quaternion[] BindRotations => rotations;

    /// <summary>Position of each joint where it was bound, metres.</summary>
    public Vector3[] BindPositions => places;

    /// <summary>The triangles, as they were bound, in metres.</summary>
    public SkinnedMesh Mesh { get; private set; } = null!;

    /// <summary>Reads all nodes with a mesh and a skin.</summary>
    public static ModelSkin Of(ModelDocument document, ModelJoints joints)
    {
        var skin = new ModelSkin(document, joints);
        foreach (JsonValue node in document.All("nodes"))
        {
            if (ModelDocument.Find(node, "mesh") is { } mesh && ModelDocument.Find(node, "skin") is { } bones)
            {
                skin.AddMesh(document.At("meshes", mesh), document.At("skins", bones));
            }
        }

        if (skin.triangles.Count == 0)
        {
            throw new ModelFault("nodes", "none with a mesh and a skin", "a skinned model");
        }

        skin.Mesh = new SkinnedMesh(skin.positions.ToArray(), skin.normals.ToArray(), skin.weights.ToArray(), skin.triangles.ToArray());
        return skin;
    }

    private void AddMesh(JsonValue mesh, JsonValue skin)
    {
        float scale = Bind(skin, out int[] bones);
        foreach (JsonValue primitive in ModelDocument.ItemsOf(mesh, "primitives"))
        {
            if (ModelDocument.Whole(primitive, "mode", 4) != 4)
            {
                throw ModelFault.At(primitive["mode"], "4 (triangles)");
            }

            AddPrimitive(primitive, bones, scale);
        }
    }

    /// <summary>Places of the joints of a skin. Gives the factor from the units of its mesh to metres.</summary>
    private float Bind(JsonValue skin, out int[] bones)
    {
        IReadOnlyList<JsonValue> named = ModelDocument.ItemsOf(skin, "joints");
        bones = new int[named.Count];
        float[]? inverses = ModelDocument.Find(skin, "inverseBindMatrices") is { } index ? accessors.Floats(index, "MAT4") : null;
        if (named.Count == 0 || (inverses != null && inverses.Length < 16 * named.Count))
        {
            throw new ModelFault(skin.Path, FormattableString.Invariant($"{(inverses?.Length ?? 0) / 16} inverse bind matrices of {named.Count} joints"), "a matrix for each joint, and one joint at least");
        }

        float scale = 0f;
        for (int i = 0; i < bones.Length; i++)
        {
            int joint = joints.JointOf(ModelDocument.Whole(named[i], int.MaxValue));
            bones[i] = joint;
            string where = named[i].Path;
            NodePlace inverse = inverses is null ? new NodePlace(Quaternion.Identity, Vector3.Zero, 1f) : NodePlace.OfMatrix(inverses.AsSpan(16 * i, 16), where + " (its inverse bind matrix)");
            float unit = joints.Scales[joint] * inverse.Scale;
            scale = i == 0 ? unit : scale;
            if (!(Math.Abs(unit - scale) <= Apart * scale))
            {
                throw new ModelFault(where, FormattableString.Invariant($"a scale of {unit} from mesh to joint, of others {scale}"), "one scale for all joints of a skin");
            }

            Quaternion rotation = Rotation.Inverse(inverse.Rotation);
            Set(joint, rotation, Rotation.Rotate(rotation, -inverse.Position * joints.Scales[joint]), where);
        }

        return scale;
    }

    private void Set(int joint, Quaternion rotation, Vector3 place, string where)
    {
        if (bound[joint])
        {
            Quaternion apart = Rotation.Multiply(Rotation.Inverse(rotations[joint]), rotation);
            if (Vec.Distance(places[joint], place) > Apart || Vec.Length(new Vector3(apart.X, apart.Y, apart.Z)) > Apart)
            {
                throw new ModelFault(where, "a joint that two skins bind in different places", "one bind pose for all skins");
            }

            return;
        }

        bound[joint] = true;
        rotations[joint] = rotation;
        places[joint] = place;
    }

    private void AddPrimitive(JsonValue primitive, int[] bones, float scale)
    {
        JsonValue attributes = ModelDocument.Need(primitive, "attributes", "positions, joints and weights");
        float[] points = accessors.Floats(ModelDocument.Need(attributes, "POSITION", "positions"), "VEC3");
        int count = points.Length / 3;
        int first = positions.Count;
        if (first + count > MaxVertices)
        {
            throw new ModelFault(primitive.Path, FormattableString.Invariant($"{first + count} vertices so far"), FormattableString.Invariant($"at most {MaxVertices}"));
        }

        int[] corners = ModelDocument.Find(primitive, "indices") is { } indices ? accessors.Integers(indices, "SCALAR") : Row(count);
        if (corners.Length == 0 || corners.Length % 3 != 0)
        {
            throw new ModelFault(primitive.Path, FormattableString.Invariant($"{corners.Length} indices"), "three for each triangle");
        }

        var here = new Vector3[count];
        for (int i = 0; i < count; i++)
        {
            here[i] = new Vector3(points[3 * i], points[(3 * i) + 1], points[(3 * i) + 2]) * scale;
        }

        foreach (int corner in corners)
        {
            triangles.Add(corner < count ? first + corner : throw new ModelFault(primitive.Path, FormattableString.Invariant($"vertex {corner}"), FormattableString.Invariant($"one of {count}")));
        }

        positions.AddRange(here);
        AddNormals(attributes, here, corners);
        AddWeights(primitive, attributes, bones, count);
    }

    private void AddNormals(JsonValue attributes, Vector3[] here, int[] corners)
    {
        var smooth = new Vector3[here.Length];
        if (ModelDocument.Find(attributes, "NORMAL") is { } index)
        {
            float[] numbers = accessors.Floats(index, "VEC3");
            Require(index, numbers.Length / 3, here.Length);
            for (int i = 0; i < smooth.Length; i++)
            {
                smooth[i] = Vec.Normalize(new Vector3(numbers[3 * i], numbers[(3 * i) + 1], numbers[(3 * i) + 2]), Vector3.UnitY);
            }
        }
        else
        {
            SurfaceNormals.Smooth(here, corners, smooth);
        }

        normals.AddRange(smooth);
    }

    private void AddWeights(JsonValue primitive, JsonValue attributes, int[] bones, int count)
    {
        var list = new InfluenceList(stackalloc int[InfluenceList.Capacity], stackalloc float[InfluenceList.Capacity]);
        var sets = new List<(int[] Joints, float[] Weights)>();
        for (int set = 0; set < 4 && ModelDocument.Find(attributes, "JOINTS_" + ModelFault.Text(set)) is { } index; set++)
        {
            JsonValue fractions = ModelDocument.Need(attributes, "WEIGHTS_" + ModelFault.Text(set), "weights");
            int[] of = accessors.Integers(index, "VEC4");
            float[] by = accessors.Floats(fractions, "VEC4");
            Require(index, of.Length / 4, count);
            Require(fractions, by.Length / 4, count);
            sets.Add((of, by));
        }

        if (sets.Count == 0)
        {
            throw ModelFault.Missing(attributes, "JOINTS_0", "joints of a skinned mesh");
        }

        for (int i = 0; i < count; i++)
        {
            list.Clear();
            foreach ((int[] of, float[] by) in sets)
            {
                for (int k = 4 * i; k < (4 * i) + 4; k++)
                {
                    if (by[k] > 0f)
                    {
                        list.Add(of[k] < bones.Length ? bones[of[k]] : throw new ModelFault(primitive.Path, FormattableString.Invariant($"joint {of[k]} of vertex {i}"), FormattableString.Invariant($"one of {bones.Length}")), by[k]);
                    }
                }
            }

            weights.Add(list.Total > 0f ? list.ToWeights() : throw new ModelFault(primitive.Path, FormattableString.Invariant($"vertex {i} without weights"), "a joint for every vertex"));
        }
    }

    private static void Require(JsonValue index, int found, int count)
    {
        if (found != count)
        {
            throw new ModelFault(index.Path, FormattableString.Invariant($"{found} elements"), FormattableString.Invariant($"{count}, one for each vertex"));
        }
    }

    private static int[] Row(int count)
    {
        int[] row = new int[count];
        for (int i = 0; i < count; i++)
        {
            row[i] = i;
        }

        return row;
    }
}
