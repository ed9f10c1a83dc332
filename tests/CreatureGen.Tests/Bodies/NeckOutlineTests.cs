using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class NeckOutlineTests
{
    /// <summary>Slope of a throat at most.</summary>
    private const float Steepest = 0.9f;

    [Fact]
    public void A_deep_head_on_a_thin_neck_runs_out_into_it()
    {
        BodyShape shape = ShapeOf(24610004, 0.6);
        var neck = new NeckOutline(shape);
        float cliff = 0f;
        float left = 0f;
        for (int i = StationRing.Cranium + 1; i < StationRing.TrunkFirst; i++)
        {
            cliff += Math.Max(0f, RiseOf(shape, i, 1f, 1f));
            left += Math.Max(0f, RiseOf(shape, i, neck.DepthAt(i - 1), neck.DepthAt(i)));
        }

        Assert.True(cliff > 0.1f, $"the throat comes up by {cliff} of the jaw's depth more than a gullet does: no cliff to be mended");
        Assert.InRange(left, 0f, 0.25f * cliff);
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(0.6)]
    [InlineData(1.0)]
    public void Nothing_becomes_thinner_and_head_and_trunk_stay_as_they_are(double strangeness)
    {
        for (ulong seed = 1; seed <= 60; seed++)
        {
            var neck = new NeckOutline(ShapeOf(seed, strangeness));
            for (int i = 0; i < BodyGrid.Rings; i++)
            {
                bool isNeck = i > StationRing.Cranium && i < StationRing.NeckBase;
                Assert.InRange(neck.DepthAt(i), 1f, isNeck ? 1.7f : 1f);
                Assert.InRange(neck.BreadthAt(i), 1f, isNeck ? 1.7f : 1f);
            }
        }
    }

    /// <summary>By how much the throat comes up more from the ring before to a ring than a gullet does, of the depth of the jaw.</summary>
    private static float RiseOf(BodyShape shape, int ring, float before, float here)
    {
        Vector3 step = Throat(ring, here) - Throat(ring - 1, before);
        return (Vec.Dot(step, shape.Up(ring)) - (Steepest * Math.Max(0f, -Vec.Dot(step, shape.Forward(ring))))) / (float)shape.Bottom[StationRing.Cranium];

        Vector3 Throat(int at, float depth) => shape.Centre(at) - Vec.Scale(shape.Up(at), depth * (float)shape.Bottom[at]);
    }

    private static BodyShape ShapeOf(ulong seed, double strangeness)
    {
        CreatureBlueprint b = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = strangeness });
        return BodyShaper.Shape(b.Plan, b.Body, b.Head, b.Tail);
    }
}
