using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class BodyEndsTests
{
    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void The_head_is_found_on_the_nose_and_the_tail_on_the_last_ring(BodyPlan plan)
    {
        RigInput input = RigSubject.Of(plan).Input;
        BodyEnds ends = BodyEnds.Find(input.Surface, input.Skin.Shape);
        VertexAddress head = input.Surface.Addresses[ends.Head];
        VertexAddress tail = input.Surface.Addresses[ends.Tail];
        Assert.Equal((SurfaceRegion.Nose, 0f), (head.Region, head.Ring));
        Assert.Equal((SurfaceRegion.Body, BodyGrid.Rings - 1f), (tail.Region, tail.Ring));
        Assert.True(input.Surface.Positions[ends.Head].Z > input.Surface.Positions[ends.Tail].Z);
    }

    [Theory]
    [InlineData(BodyPlan.Unguligrade)]
    [InlineData(BodyPlan.Eel)]
    public void No_other_pair_near_the_spine_is_farther_apart(BodyPlan plan)
    {
        RigInput input = RigSubject.Of(plan).Input;
        BodyEnds ends = BodyEnds.Find(input.Surface, input.Skin.Shape);
        float found = Vec.Distance(input.Surface.Positions[ends.Head], input.Surface.Positions[ends.Tail]);

        // The inner vertices of both caps are the only ones near the spine.
        int[] caps = Enumerable.Range(0, input.Surface.Positions.Length)
            .Where(v => input.Surface.Addresses[v].Region == SurfaceRegion.Nose || (input.Surface.Addresses[v].Ring == BodyGrid.Rings - 1 && input.Surface.Addresses[v].Region == SurfaceRegion.Body))
            .Where(v => Math.Abs(input.Surface.Positions[v].X) < 0.3f * input.Skin.Shape.Width[(int)input.Surface.Addresses[v].Ring])
            .Where(v => Height(input, v) < 0.3f)
            .ToArray();
        float farthest = caps.SelectMany(a => caps, (a, b) => Vec.Distance(input.Surface.Positions[a], input.Surface.Positions[b])).Max();
        Assert.True(found >= farthest);
    }

    [Fact]
    public void A_surface_without_closed_ends_is_refused()
    {
        RigInput input = RigSubject.Of(BodyPlan.Fish).Input;
        var builder = new SurfaceBuilder();
        for (int k = 0; k < 4; k++)
        {
            builder.Add(new Vector3(1f + k, k, k), new VertexAddress { Appendage = -1, Sign = 1, Ring = 20 });
        }

        builder.Quad(0, 1, 2, 3, builder.NewChart(), default);
        ArgumentException error = Assert.Throws<ArgumentException>(() => BodyEnds.Find(Surface.From(builder, out _), input.Skin.Shape));
        Assert.Contains("0 vertices near the spine; expected closed ends", error.Message, StringComparison.Ordinal);
    }

    private static double Height(RigInput input, int v)
    {
        int ring = (int)input.Surface.Addresses[v].Ring;
        float y = Vec.Dot(input.Surface.Positions[v] - input.Skin.Shape.Centre(ring), input.Skin.Shape.Up(ring));
        return Math.Abs(y) / (y > 0 ? input.Skin.Shape.Top[ring] : input.Skin.Shape.Bottom[ring]);
    }
}
