using System;
using CreatureGen.Creatures;
using CreatureGen.Engines;
using Godot;

namespace CreatureGen.GodotAddon;

/// <summary>Meshes, skeletons and materials of creatures as Godot has them.</summary>
public static class CreatureMeshes
{
    /// <summary>The bones at rest.</summary>
    public static Skeleton3D Bones(Creature creature)
    {
        var rotations = new System.Numerics.Quaternion[creature.Skeleton.Count];
        var positions = new System.Numerics.Vector3[creature.Skeleton.Count];
        creature.Skeleton.For(EngineAxes.Godot).FillRestPose(new Rigging.Pose(rotations, positions));
        var skeleton = new Skeleton3D();
        for (int joint = 0; joint < rotations.Length; joint++)
        {
            skeleton.AddBone(creature.Skeleton.Joints[joint].Name);
            skeleton.SetBoneParent(joint, creature.Skeleton.Parents[joint]);
            var rotation = new Quaternion(rotations[joint].X, rotations[joint].Y, rotations[joint].Z, rotations[joint].W);
            skeleton.SetBoneRest(joint, new Transform3D(new Basis(rotation), GodotSpace.Point(positions[joint])));
        }

        return skeleton;
    }

    /// <summary>Where the bones were when the skin was laid on them.</summary>
    public static Skin Binds(Creature creature)
    {
        var binds = new System.Numerics.Matrix4x4[creature.Skeleton.Count];
        creature.Skeleton.For(EngineAxes.Godot).FillInverseBinds(binds);
        var skin = new Skin();
        for (int joint = 0; joint < binds.Length; joint++)
        {
            skin.AddBind(joint, GodotSpace.Transform(binds[joint]));
        }

        return skin;
    }

    /// <summary>The surface, in one piece.</summary>
    public static ArrayMesh Surface(Creature creature)
    {
        CreatureMesh textured = creature.Mesh.Textured();
        EngineMesh source = textured.For(EngineAxes.Godot);
        int count = source.VertexCount;
        var positions = new System.Numerics.Vector3[count];
        var normals = new System.Numerics.Vector3[count];
        var texcoords = new System.Numerics.Vector2[count];
        var colours = new System.Numerics.Vector4[count];
        var joints = new ushort[4 * count];
        var weights = new System.Numerics.Vector4[count];
        var indices = new int[source.IndexCount];
        source.FillPositions(positions);
        source.FillNormals(normals);
        source.FillTexcoords(texcoords);
        source.FillColours(colours);
        source.FillInfluences(joints, weights);
        source.FillIndices(indices);
        var shown = new Color[count];
        var influences = new float[4 * count];
        for (int i = 0; i < count; i++)
        {
            // What the atlas paints is white; eyes, claws and teeth lie on white texels and keep their colours.
            shown[i] = CreatureTextures.KeepsItsColour(textured.Texcoords[i]) ? new Color(colours[i].X, colours[i].Y, colours[i].Z) : new Color(1f, 1f, 1f);
            (influences[4 * i], influences[(4 * i) + 1], influences[(4 * i) + 2], influences[(4 * i) + 3]) = (weights[i].X, weights[i].Y, weights[i].Z, weights[i].W);
        }

        var arrays = new Godot.Collections.Array();
        arrays.Resize((int)Mesh.ArrayType.Max);
        arrays[(int)Mesh.ArrayType.Vertex] = Array.ConvertAll(positions, GodotSpace.Point);
        arrays[(int)Mesh.ArrayType.Normal] = Array.ConvertAll(normals, GodotSpace.Point);
        arrays[(int)Mesh.ArrayType.TexUV] = Array.ConvertAll(texcoords, v => new Vector2(v.X, v.Y));
        arrays[(int)Mesh.ArrayType.Color] = shown;
        arrays[(int)Mesh.ArrayType.Bones] = Array.ConvertAll(joints, joint => (int)joint);
        arrays[(int)Mesh.ArrayType.Weights] = influences;
        arrays[(int)Mesh.ArrayType.Index] = indices;
        var mesh = new ArrayMesh();
        mesh.AddSurfaceFromArrays(Mesh.PrimitiveType.Triangles, arrays);
        return mesh;
    }

    /// <summary>The material, with the atlas of the skin; seen from both sides, for membranes are thin.</summary>
    public static StandardMaterial3D Coat(Creature creature, int size)
    {
        Image picture = Image.CreateFromData(size, size, false, Image.Format.Rgb8, CreatureTextures.Bake(creature, size).BaseColour.ToArray());
        return new StandardMaterial3D { AlbedoTexture = ImageTexture.CreateFromImage(picture), VertexColorUseAsAlbedo = true, Roughness = 0.7f, CullMode = BaseMaterial3D.CullModeEnum.Disabled };
    }
}
