using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>A person with the joints' names of another program, at rest with arms spread, and its walk of a second.</summary>
internal static class Walker
{
    private const float Leg = 0.88f;

    /// <summary>The skeleton.</summary>
    public static Skeleton Rig() => Skeleton.Build([
        Joint("Hips", -1, 0f, 0.98f, 0f), Joint("Spine", 0, 0f, 0.12f, 0f), Joint("Spine1", 1, 0f, 0.2f, 0f), Joint("Neck", 2, 0f, 0.22f, 0f), Joint("Head", 3, 0f, 0.1f, 0.02f), Joint("HeadTop_End", 4, 0f, 0.2f, 0f),
        .. new[] { ("Left", 1f), ("Right", -1f) }.SelectMany((one, i) => new[]
        {
            Joint(one.Item1 + "UpLeg", 0, 0.1f * one.Item2, -0.04f, 0f), Joint(one.Item1 + "Leg", 6 + (7 * i), 0f, -0.45f, 0.01f), Joint(one.Item1 + "Foot", 7 + (7 * i), 0f, -0.43f, -0.02f), Joint(one.Item1 + "ToeBase", 8 + (7 * i), 0f, -0.05f, 0.15f),
            Joint(one.Item1 + "Arm", 2, 0.19f * one.Item2, 0.16f, 0f), Joint(one.Item1 + "ForeArm", 10 + (7 * i), 0.28f * one.Item2, 0f, 0f), Joint(one.Item1 + "Hand", 11 + (7 * i), 0.25f * one.Item2, 0f, 0f),
        }),
    ]);

    /// <summary>Legs swing and bend, arms hang and swing against them, hips sink as the legs are apart.</summary>
    public static KeyedClip Walk()
    {
        float[] times = [.. Enumerable.Range(0, 25).Select(k => k / 24f)];
        Vector3 hips = Rig().LocalPositions[0];
        KeyTrack Turns(Joint joint) => KeyTrack.OfRotations(times, [.. times.Select(t => Turn(joint.Name, t))], KeyInterpolation.Linear);
        KeyTrack Places(Joint joint) => joint.Name == "Hips"
            ? KeyTrack.OfPositions(times, [.. times.Select(t => hips - new Vector3(0f, Leg * (1.01f - MathF.Cos(Swing(t))), 0f))], KeyInterpolation.Linear)
            : KeyTrack.OfPositions([0f], [joint.LocalPosition], KeyInterpolation.Step);
        return new KeyedClip("Walk", ClipEnd.Loops, 1f, 4f * Leg * MathF.Sin(0.42f), [.. Rig().Joints.Select(Turns)], [.. Rig().Joints.Select(Places)], []);
    }

    private static float Swing(float t) => -0.42f * MathF.Sin(MathF.Tau * t);

    private static Quaternion Turn(string name, float t)
    {
        (float side, float at) = name.StartsWith("Left", StringComparison.Ordinal) ? (1f, t) : (-1f, t + 0.5f);
        float knee = 0.08f + (0.8f * MathF.Max(0f, MathF.Cos(MathF.Tau * at)));
        float push = 0.5f * MathF.Max(0f, MathF.Cos(MathF.Tau * (at - 0.85f)) - 0.5f);
        return name.Replace("Left", "", StringComparison.Ordinal).Replace("Right", "", StringComparison.Ordinal) switch
        {
            "UpLeg" => About(Vector3.UnitX, Swing(at) - (0.4f * knee)),
            "Leg" => About(Vector3.UnitX, knee),
            "Foot" => About(Vector3.UnitX, push - Swing(at) - (0.6f * knee)),
            "Arm" => About(Vector3.UnitX, 0.5f * MathF.Sin(MathF.Tau * at)) * About(Vector3.UnitZ, -1.35f * side),
            "ForeArm" => About(Vector3.UnitY, -0.35f * side),
            "Spine1" => About(Vector3.UnitY, 0.1f * MathF.Sin(MathF.Tau * t)),
            _ => Quaternion.Identity,
        };
    }

    private static Quaternion About(Vector3 axis, float angle) => Quaternion.CreateFromAxisAngle(axis, angle);

    private static JointPlacement Joint(string name, int parent, float x, float y, float z) => new(name, parent, Quaternion.Identity, new Vector3(x, y, z));
}
