using System.Linq;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

public sealed class LongUpdateTests
{
    /// <summary>A hoofed walker, two sprawlers and a flier on foot whose trunks took feet along by 3.5, 3.4, 3.2 and 8 % of a leg within one update of 33 to 250 ms.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 9920007)]
    [InlineData(RequestedKind.Walking, 9920006, Explicit = true)]
    [InlineData(RequestedKind.Walking, 9920028, Explicit = true)]
    [InlineData(RequestedKind.Flying, 9920006)]
    public void Feet_that_a_long_update_takes_from_their_places_are_let_go(RequestedKind kind, ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
        CourseReport report = MotionCourse.Of(profile).First(run => run.Rate == CourseRate.Uneven).Run(profile);
        Assert.True(report.StanceSlip < 0.02f, $"{report.StanceSlip} legs of slip");
        Assert.True(report.JointSpeed < 60f, $"{report.JointSpeed} rad/s");
    }
}
