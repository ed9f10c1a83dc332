using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Slithering;
using Xunit;

namespace CreatureGen.Tests.Motion.Slithering;

public sealed class SlitherTrackTests
{
    private static readonly Vector3 Slope = Vector3.Normalize(new Vector3(0f, 1f, -1f));

    [Fact]
    public void A_way_turns_evenly_from_one_heading_to_the_other()
    {
        var steering = new TrackSteering(0.2, 1.0, 0.1, 0, 0);
        Assert.Equal(0.2, steering.CourseAngleAt(0), 12);
        Assert.Equal(0.4, steering.CourseAngleAt(0.25), 12);
        Assert.Equal(1.0, steering.CourseAngleAt(1), 12);
        Assert.Equal(0.7, steering.HeadingAt(3, 0.5, 1), 12);
    }

    /// <summary>Up a slope of 45° a metre of body is 0.71 m on the map.</summary>
    [Fact]
    public void On_a_slope_the_same_way_along_the_body_is_less_way_over_the_map()
    {
        SlitherTrack track = Straight();
        CrawlFloor floor = Floor();
        double z = track.HeadPoint.Z;
        double y = track.HeadPoint.Y;
        for (int i = 0; i < 10; i++)
        {
            track.Advance(0.1, default, floor);
        }

        Assert.Equal(Math.Sqrt(0.5), track.HeadPoint.Z - z, 1e-3);
        Assert.Equal(Math.Sqrt(0.5), track.HeadPoint.Y - y, 1e-3);
    }

    [Fact]
    public void A_track_that_is_carried_along_turns_with_its_points_and_their_normals()
    {
        SlitherTrack track = Straight();
        TrackPoint before = track.At(-0.5);
        track.Carry(PortableMath.Pi / 2, 1, 2, 3);
        TrackPoint after = track.At(-0.5);
        Assert.Equal(before.Z + 1, after.X, 1e-9);
        Assert.Equal(before.Y + 2, after.Y, 1e-9);
        Assert.Equal(-before.X + 3, after.Z, 1e-9);
        Assert.True(Vector3.Distance(new Vector3(before.Normal.Z, before.Normal.Y, -before.Normal.X), after.Normal) < 1e-5f, after.Normal.ToString());
        Assert.Equal(PortableMath.Pi / 2, track.CourseAngleAt(-0.5), 1e-9);
    }

    [Fact]
    public void A_copy_goes_on_as_what_it_was_taken_from()
    {
        CrawlFloor floor = Floor();
        SlitherTrack track = Straight();
        track.Advance(0.73, new TrackSteering(0, 0.4, 0, 0, 0), floor);
        var copy = new SlitherTrack(2, 1);
        copy.CopyFrom(track);
        TrackPoint neck = track.At(track.Head - 0.4);
        TrackPoint same = copy.At(copy.Head - 0.4);
        Assert.Equal((neck.X, neck.Y, neck.Z, neck.Normal), (same.X, same.Y, same.Z, same.Normal));
        for (int i = 0; i < 5; i++)
        {
            track.Advance(0.21, new TrackSteering(0.4, 0.1, 0, 0, 0), floor);
            copy.Advance(0.21, new TrackSteering(0.4, 0.1, 0, 0, 0), floor);
            foreach (double back in new[] { 0.0, 0.3, 0.9, 1.6 })
            {
                TrackPoint expected = track.At(track.Head - back);
                TrackPoint found = copy.At(copy.Head - back);
                Assert.Equal((expected.X, expected.Y, expected.Z, expected.Normal), (found.X, found.Y, found.Z, found.Normal));
            }
        }
    }

    private static SlitherTrack Straight()
    {
        var track = new SlitherTrack(2, 1);
        track.Lay(0, 0, 0, default, Floor());
        return track;
    }

    private static CrawlFloor Floor() => new(new FlatGround(Vector3.Zero, Slope), 1f, 4f);
}
