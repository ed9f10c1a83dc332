using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Events;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Events;

/// <summary>Rules with sweeps any way, fractions of all joints together, and moments near rest, heard while a motion goes on.</summary>
public sealed class LiveOptionsTests
{
    private const float Rate = 60f;

    private static readonly Skeleton beast = Skeleton.Build([Joint("Body", -1, 0f), Joint("Tail1", 0, -0.5f), Joint("Tail2", 1, -0.5f), Joint("Tail_End", 2, -0.5f), Joint("Fin", 0, 0.3f), Joint("Fin_End", 4, 0.3f), Joint("Jaw", 0, 0.5f), Joint("Jaw_End", 6, 0.2f)]);

    /// <summary>Once a second to each side: fastest in the middle.</summary>
    [Fact]
    public void A_tail_that_beats_is_told_where_it_is_fastest_a_sixth_of_its_beat_later_and_a_fin_that_only_quivers_is_not()
    {
        List<(float Time, int Joint, float Ago)> heard = Hear(AngularRules.Splash, t => (0.6f * MathF.Sin(MathF.Tau * t), 0.05f * MathF.Sin(2f * MathF.Tau * t), 0f));
        Assert.InRange(heard.Count, 9, 11);
        Assert.All(heard, one => Assert.Equal(3, one.Joint));
        Assert.All(heard, one => Assert.InRange(MathF.Abs((2f * one.Time) - MathF.Round(2f * one.Time)), 0f, 2f * 0.02f));
        Assert.All(heard, one => Assert.InRange(one.Ago, 0f, 1f / 6f));
    }

    /// <summary>Open for half a second, shut within a tenth.</summary>
    [Fact]
    public void A_jaw_that_snaps_is_told_where_it_is_shut_and_not_where_it_opens()
    {
        List<(float Time, int Joint, float Ago)> heard = Hear(AngularRules.Bite, t => (0f, 0f, 0.5f * Gape(t % 1f)));
        Assert.InRange(heard.Count, 4, 5);
        Assert.All(heard, one => Assert.InRange(one.Time % 1f, 0.55f, 0.65f));
        Assert.All(heard, one => Assert.InRange(one.Ago, 0f, 0.06f));
    }

    private static float Gape(float t) => t < 0.5f ? 0.5f - (0.5f * MathF.Cos(MathF.PI * t / 0.5f)) : t < 0.6f ? 1f - (((t - 0.5f) / 0.1f) * ((t - 0.5f) / 0.1f)) : 0f;

    private static List<(float Time, int Joint, float Ago)> Hear(AngularRule rule, Func<float, (float Tail, float Fin, float Jaw)> motion)
    {
        var stream = new AngularEventStream(beast, rule);
        var local = new Pose(new Quaternion[beast.Count], new Vector3[beast.Count]);
        var model = new Pose(new Quaternion[beast.Count], new Vector3[beast.Count]);
        var heard = new List<(float, int, float)>();
        for (int i = 0; i <= 5 * Rate; i++)
        {
            (float tail, float fin, float jaw) = motion(i / Rate);
            local.SetToRest(beast);
            local.Rotations[1] = Quaternion.CreateFromAxisAngle(Vector3.UnitY, tail);
            local.Rotations[4] = Quaternion.CreateFromAxisAngle(Vector3.UnitY, fin);
            local.Rotations[6] = Quaternion.CreateFromAxisAngle(Vector3.UnitX, jaw);
            ForwardKinematics.LocalToModel(beast, local, model);
            stream.Update(local, model, 1f / Rate);
            foreach (AngularMoment moment in stream.Found)
            {
                heard.Add(((i / Rate) - moment.SecondsAgo, moment.Joint, moment.SecondsAgo));
            }
        }

        return heard;
    }

    private static JointPlacement Joint(string name, int parent, float z) => new(name, parent, Quaternion.Identity, new Vector3(0f, parent < 0 ? 1f : 0f, z));
}
