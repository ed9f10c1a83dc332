using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>
/// The hollow of a joint that folds deep to one side: of a knee, an elbow, a hock, a carpus. There a thick limb has less skin than the bend takes away, and rings of vertices lie close together.
/// </summary>
/// <remarks>
/// In the hollow the skin goes over from bone to bone by where it lies, not by its share of the path, within a shorter stretch and above the joint, as the crease of a knee lies above its joint line.
/// What lies below keeps its shape and goes in under the upper part in one fold, instead of being crumpled all the way.
/// </remarks>
internal sealed class JointCrease
{
    /// <summary>How far above a joint that folds to one side only the skin goes over, in path lengths of the part above.</summary>
    private const float Height = 0.08f;

    /// <summary>Where a hollow begins and where all is hollow, from the joint towards where it folds, in lengths of the part above.</summary>
    private const float Start = 0.05f;
    private const float End = 0.3f;

    /// <summary>Part of the usual stretch in which the skin of a hollow goes over.</summary>
    private const float Narrow = 0.4f;

    private readonly Vector3 joint;
    private readonly Vector3 fold;
    private readonly Vector3 onwards;
    private readonly float along;
    private readonly float span;
    private readonly float height;

    /// <summary>Measures the joint between two parts of a limb.</summary>
    /// <param name="appendage">The limb.</param>
    /// <param name="k">Number of the joint along it, neither the first nor the last.</param>
    /// <param name="limit">How far it turns.</param>
    /// <param name="rotation">Its frame at rest, model space.</param>
    public JointCrease(Appendage appendage, int k, in JointLimit limit, Quaternion rotation)
    {
        joint = appendage.Joints[k];
        along = appendage.JointsAlong[k];
        Vector3 before = joint - appendage.Joints[k - 1];
        Vector3 after = appendage.Joints[k + 1] - joint;
        float length = Math.Max(Vec.Length(before), 1e-6f);
        float fraction = along - appendage.JointsAlong[k - 1];
        bool forwards = limit.SwingX.Max > -limit.SwingX.Min;
        float deep = forwards ? limit.SwingX.Max : -limit.SwingX.Min;
        float shallow = forwards ? -limit.SwingX.Min : limit.SwingX.Max;
        fold = Rotation.Rotate(rotation, forwards ? Vector3.UnitZ : -Vector3.UnitZ) / length;
        onwards = Vec.Normalize(Vec.Normalize(before) + Vec.Normalize(after)) * (fraction / length);
        span = Math.Min(fraction, appendage.JointsAlong[k + 1] - along);
        height = Height * fraction * Math.Max(1f - (shallow / deep), 0f);
    }

    /// <summary>How much of the skin at a point lies beyond the joint, 0..1, before any easing.</summary>
    /// <param name="position">The point, model space, metres at scale 1.</param>
    /// <param name="x">Its share of the path.</param>
    /// <param name="stretch">Half width of the change outside the hollow.</param>
    public float Passed(Vector3 position, float x, float stretch)
    {
        Vector3 from = position - joint;
        float depth = Scalar.Smooth((Vec.Dot(from, fold) - Start) / (End - Start));
        float near = 1f - Scalar.Smooth((2f * Math.Abs(x - along) / span) - 1f);
        float beyond = Scalar.Lerp(x - along, Vec.Dot(from, onwards), depth * near) + (height * depth);
        float half = stretch * Scalar.Lerp(1f, Narrow, depth);
        return Scalar.Clamp((beyond + half) / (2f * half), 0f, 1f);
    }
}
