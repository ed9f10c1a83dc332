using System;
using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf;

/// <summary>A joint's place in double precision: a rotation as a matrix with columns, and a position.</summary>
internal readonly struct JointFrame
{
    private readonly double xx;
    private readonly double xy;
    private readonly double xz;
    private readonly double yx;
    private readonly double yy;
    private readonly double yz;
    private readonly double zx;
    private readonly double zy;
    private readonly double zz;
    private readonly double px;
    private readonly double py;
    private readonly double pz;

    /// <summary>The frame at <paramref name="position"/>, turned by <paramref name="rotation"/>, whose length does not matter but must not be zero.</summary>
    public JointFrame(Vector3 position, Quaternion rotation)
    {
        double x = rotation.X;
        double y = rotation.Y;
        double z = rotation.Z;
        double w = rotation.W;
        double s = 2.0 / ((x * x) + (y * y) + (z * z) + (w * w));
        xx = 1.0 - (s * ((y * y) + (z * z)));
        xy = s * ((x * y) + (w * z));
        xz = s * ((x * z) - (w * y));
        yx = s * ((x * y) - (w * z));
        yy = 1.0 - (s * ((x * x) + (z * z)));
        yz = s * ((y * z) + (w * x));
        zx = s * ((x * z) + (w * y));
        zy = s * ((y * z) - (w * x));
        zz = 1.0 - (s * ((x * x) + (y * y)));
        px = position.X;
        py = position.Y;
        pz = position.Z;
    }

    /// <summary>The rest pose of a joint in model space.</summary>
    public static JointFrame InModel(Joint joint) => new(joint.ModelPosition, joint.ModelRotation);

    /// <summary>A direction of the outer space, seen from this frame.</summary>
    public Vector3 DirectionToLocal(Vector3 d) => new(
        (float)((xx * d.X) + (xy * d.Y) + (xz * d.Z)),
        (float)((yx * d.X) + (yy * d.Y) + (yz * d.Z)),
        (float)((zx * d.X) + (zy * d.Y) + (zz * d.Z)));

    /// <summary>A point of the outer space, seen from this frame.</summary>
    public Vector3 PointToLocal(Vector3 p)
    {
        double x = p.X - px;
        double y = p.Y - py;
        double z = p.Z - pz;
        return new Vector3(
            (float)((xx * x) + (xy * y) + (xz * z)),
            (float)((yx * x) + (yy * y) + (yz * z)),
            (float)((zx * x) + (zy * y) + (zz * z)));
    }
}
