using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Skinning;

/// <summary>Bends of every plan's skin keep its volume and do not turn it inside out.</summary>
public sealed class BendTests
{
    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Hips_swing_35_degrees_both_ways(BodyPlan plan)
    {
        Holds(plan, 0.03, 0.005, j => j.Role == JointRole.Hip ? X(35) : null);
        Holds(plan, 0.03, 0.005, j => j.Role == JointRole.Hip ? X(-35) : null);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Knees_fold_60_degrees(BodyPlan plan) => Holds(plan, 0.04, 0.008, j => j.Role == JointRole.Knee ? X(60 * Fold(j)) : null);

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Ankles_fold_50_degrees_or_to_their_limit(BodyPlan plan) =>
        // The columns of rhinos are as thick as their feet are long.
        Holds(plan, 0.02, plan == BodyPlan.Columnar ? 0.007 : 0.006, j => j.Role == JointRole.Ankle ? X(Math.Min(50, Scalar.Degrees(Math.Max(j.Limit.SwingX.Max, -j.Limit.SwingX.Min))) * Fold(j)) : null);

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Necks_and_heads_turn_to_their_limits(BodyPlan plan)
    {
        Holds(plan, 0.05, 0.02, j => j.Role is JointRole.Neck or JointRole.Head ? Rotation.FromAxisAngle(Vector3.UnitX, j.Limit.SwingX.Min) : null);
        Holds(plan, 0.05, 0.02, j => j.Role is JointRole.Neck or JointRole.Head ? Rotation.FromAxisAngle(Vector3.UnitZ, j.Limit.SwingZ.Max) : null);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Spines_and_tails_bend_sideways_to_their_limits(BodyPlan plan) =>
        // A cobra's hood is wide for the length of its bones.
        Holds(plan, plan == BodyPlan.Legless ? 0.08 : 0.05, 0.02, j => j.Role is JointRole.Spine or JointRole.Tail or JointRole.Chest ? Rotation.FromAxisAngle(Vector3.UnitZ, j.Limit.SwingZ.Max) : null);

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Tails_rise_15_degrees_in_each_bone(BodyPlan plan) => Holds(plan, 0.02, 0.005, j => j.Role == JointRole.Tail ? X(Math.Min(15, Scalar.Degrees(j.Limit.SwingX.Max))) : null);

    [Fact]
    public void Wings_beat_45_degrees_up_and_down_and_fold()
    {
        Holds(BodyPlan.Flapping, 0.02, 0.002, j => j.Role == JointRole.Wing && j.Name.EndsWith("_1", StringComparison.Ordinal) ? X(45) : null);
        Holds(BodyPlan.Flapping, 0.02, 0.002, j => j.Role == JointRole.Wing && j.Name.EndsWith("_1", StringComparison.Ordinal) ? X(-45) : null);
        Holds(BodyPlan.Flapping, 0.02, 0.01, j => j.Role == JointRole.Wing && j.Name.EndsWith("_3", StringComparison.Ordinal) ? Rotation.FromAxisAngle(Vector3.UnitZ, 0.5 * (j.Side == Side.Left ? 1 : -1)) : null);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Jaws_open_20_degrees_and_fins_and_ears_lean(BodyPlan plan)
    {
        Holds(plan, 0.08, 0.004, j => j.Role == JointRole.Jaw ? X(20) : null);
        Holds(plan, 0.02, 0.01, j => j.Role is JointRole.Fin or JointRole.Ear ? Rotation.FromAxisAngle(Vector3.UnitZ, 0.3 * (j.Side == Side.Right ? -1 : 1)) : null);
    }

    private static Quaternion X(double degrees) => Rotation.FromAxisAngle(Vector3.UnitX, Scalar.Radians(degrees));

    private static double Fold(Joint joint) => joint.Limit.SwingX.Max > -joint.Limit.SwingX.Min ? 1 : -1;

    /// <summary>In the mean of six creatures of a plan within both bounds, and each of them within two and a half times of these: stout limbs on slender bodies are worth more of their volume than slender ones on stout bodies.</summary>
    private static void Holds(BodyPlan plan, double volume, double inverted, Func<Joint, Quaternion?> turn)
    {
        (double Change, double Share)[] bends = Array.ConvertAll(RigSubject.Several(plan), subject => SkinFacts.Bend(subject, subject.Weights, turn));
        Assert.True(bends.Average(bend => Math.Abs(bend.Change)) <= volume, $"the volume changes by {bends.Average(bend => Math.Abs(bend.Change)):P2}");
        Assert.True(bends.Average(bend => bend.Share) <= inverted, $"{bends.Average(bend => bend.Share):P2} of the triangles turn inside out");
        Assert.All(bends, bend => Assert.InRange(Math.Abs(bend.Change), 0, 2.5 * volume));
        Assert.All(bends, bend => Assert.InRange(bend.Share, 0, 2.5 * inverted));
    }
}
