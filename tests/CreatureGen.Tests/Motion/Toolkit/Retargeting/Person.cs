using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Tests.Motion.Toolkit.Retargeting;

/// <summary>A person in a T as other programs name the joints, and how it walks.</summary>
internal static class Person
{
    public const float Stride = 1.2f;

    public static Skeleton Skeleton { get; } = Skeleton.Build([
        Joint("mixamorig:Hips", -1, 0f, 0.95f, 0f), Joint("mixamorig:Spine", 0, 0f, 0.12f, 0f), Joint("mixamorig:Spine2", 1, 0f, 0.25f, 0f), Joint("mixamorig:Neck", 2, 0f, 0.15f, 0f), Joint("mixamorig:Head", 3, 0f, 0.1f, 0f),
        Joint("mixamorig:LeftUpLeg", 0, 0.1f, -0.05f, 0f), Joint("mixamorig:LeftLeg", 5, 0f, -0.42f, 0.01f), Joint("mixamorig:LeftFoot", 6, 0f, -0.4f, -0.02f), Joint("mixamorig:LeftToeBase", 7, 0f, -0.06f, 0.14f),
        Joint("mixamorig:RightUpLeg", 0, -0.1f, -0.05f, 0f), Joint("mixamorig:RightLeg", 9, 0f, -0.42f, 0.01f), Joint("mixamorig:RightFoot", 10, 0f, -0.4f, -0.02f), Joint("mixamorig:RightToeBase", 11, 0f, -0.06f, 0.14f),
        Joint("mixamorig:LeftArm", 2, 0.18f, 0.1f, 0f), Joint("mixamorig:LeftForeArm", 13, 0.28f, 0f, 0f), Joint("mixamorig:LeftHand", 14, 0.25f, 0f, 0f),
        Joint("mixamorig:RightArm", 2, -0.18f, 0.1f, 0f), Joint("mixamorig:RightForeArm", 16, -0.28f, 0f, 0f), Joint("mixamorig:RightHand", 17, -0.25f, 0f, 0f),
    ]);

    /// <summary>A walk of a second: legs swing, knees bend as they come forward, arms hang and swing against the legs.</summary>
    public static KeyedClip Walk()
    {
        const int Keys = 25;
        float[] times = [.. Enumerable.Range(0, Keys).Select(k => k / (float)(Keys - 1))];
        var rotations = new List<KeyTrack>();
        var positions = new List<KeyTrack>();
        foreach (Joint joint in Skeleton.Joints)
        {
            rotations.Add(KeyTrack.OfRotations(times, [.. times.Select(t => TurnOf(joint.Name, t % 1f))], KeyInterpolation.Linear));
            positions.Add(KeyTrack.OfPositions([0f], [joint.LocalPosition], KeyInterpolation.Step));
        }

        return new KeyedClip("mixamo.com|Walk", ClipEnd.Loops, 1f, Stride, rotations, positions, [new ClipEvent(0.25f, "footstep", "mixamorig:LeftFoot", 1f)]);
    }

    private static Quaternion TurnOf(string name, float t)
    {
        float side = name.Contains("Left", StringComparison.Ordinal) ? 1f : -1f;
        float phase = MathF.Tau * (side > 0f ? t : t + 0.5f);
        return name[(name.IndexOf(':', StringComparison.Ordinal) + 1)..].Replace("Left", "", StringComparison.Ordinal).Replace("Right", "", StringComparison.Ordinal) switch
        {
            "UpLeg" => About(Vector3.UnitX, -0.45f * MathF.Sin(phase)),
            "Leg" => About(Vector3.UnitX, 0.15f + (0.45f * MathF.Max(0f, MathF.Cos(phase)))),
            "Arm" => About(Vector3.UnitX, 0.4f * MathF.Sin(phase)) * About(Vector3.UnitZ, -1.35f * side),
            "Spine2" => About(Vector3.UnitY, 0.08f * MathF.Sin(MathF.Tau * t)),
            _ => Quaternion.Identity,
        };
    }

    private static Quaternion About(Vector3 axis, float angle) => Quaternion.CreateFromAxisAngle(axis, angle);

    private static JointPlacement Joint(string name, int parent, float x, float y, float z) => new(name, parent, Quaternion.Identity, new Vector3(x, y, z));
}
