using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion.Metrics.Courses;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics.Courses;

public sealed class StanceWatchTests
{
    // A sole of five vertices, a leg of one metre.
    private static readonly Vector3[] sole = Enumerable.Range(0, 5).Select(i => new Vector3(0f, 0f, 0.05f * i)).ToArray();

    [Fact]
    public void A_foot_that_slides_slips_by_the_way_that_it_slid()
    {
        StanceWatch watch = Watch(10, (point, update) => point + new Vector3(0.003f * update, 0f, 0.004f * update));
        Assert.Equal(9 * 0.005f, watch.Lift()!.Value, 1e-5f);
    }

    [Fact]
    public void A_foot_that_stands_turns_or_rolls_does_not_slip()
    {
        Assert.Equal(0f, Watch(10, (point, _) => point).Lift());
        Assert.Equal(0f, Watch(10, (point, update) => Turned(point - sole[2], 0.05f * update) + sole[2]).Lift()!.Value, 1e-6f);

        // From heel to toe: what has left the ground may go where it likes.
        Assert.Equal(0f, Watch(4, (point, update) => point.Z < 0.05f * update - 0.01f ? point + new Vector3(0f, 0.02f * update, 0.03f * update) : point).Lift()!.Value, 1e-6f);
    }

    [Fact]
    public void A_foot_that_floats_and_slides_slips()
    {
        StanceWatch watch = Watch(10, (point, update) => point + new Vector3(0.01f * update, 0.05f, 0f));
        Assert.Equal(0.09f, watch.Lift()!.Value, 1e-5f);
    }

    [Fact]
    public void What_happens_between_stances_does_not_count()
    {
        var watch = new StanceWatch(sole.Length, 1f);
        Stand(watch, sole);
        Assert.Null(watch.Lift());
        Assert.Null(watch.Lift());
        Vector3[] elsewhere = sole.Select(point => point + Vector3.UnitX).ToArray();
        Stand(watch, elsewhere);
        Stand(watch, elsewhere);
        Assert.Equal(0f, watch.Lift());
    }

    private static StanceWatch Watch(int updates, Func<Vector3, int, Vector3> move)
    {
        var watch = new StanceWatch(sole.Length, 1f);
        for (int i = 0; i < updates; i++)
        {
            Stand(watch, sole.Select(point => move(point, i)).ToArray());
        }

        return watch;
    }

    private static void Stand(StanceWatch watch, Vector3[] points)
    {
        float[] heights = points.Select(point => point.Y).ToArray();
        watch.Stand(points, heights, heights.Min());
    }

    private static Vector3 Turned(Vector3 point, float angle) => Vector3.Transform(point, Quaternion.CreateFromAxisAngle(Vector3.UnitY, angle));
}
