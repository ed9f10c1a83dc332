using System.Linq;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Events;

public sealed class FootstepAccuracyTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(201, 7)]
    [InlineData(201, 20, Explicit = true)]
    [InlineData(1, 100, Explicit = true)]
    [InlineData(1001, 100, Explicit = true)]
    public void The_footstep_rule_finds_95_of_100_steps_within_50_ms_and_5_of_100_are_false(int first, int count)
    {
        var figures = new FootstepFigures();
        for (int i = 0; i < count; i++)
        {
            figures.Add(CreatureGenerator.Generate((ulong)(first + i), CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        }

        output.WriteLine(figures.ToString());
        Assert.True(figures.All.Found >= 0.95 * figures.All.Steps, figures.ToString());
        Assert.True(figures.All.False <= 0.05 * (figures.All.Found + figures.All.False), figures.ToString());
        Assert.All(figures.Gaits.Where(gait => gait.Value.Steps >= 20), gait => Assert.True(gait.Value.Found >= 0.95 * gait.Value.Steps && gait.Value.False <= 0.05 * (gait.Value.Found + gait.Value.False), gait.Key));
    }

    [Theory]
    [InlineData(301, 4)]
    [InlineData(301, 10, Explicit = true)]
    [InlineData(1, 100, Explicit = true)]
    public void A_live_stream_finds_95_of_100_steps_within_50_ms_and_5_of_100_are_false(int first, int count)
    {
        var figures = new FootstepFigures();
        for (int i = 0; i < count; i++)
        {
            figures.AddLive(CreatureGenerator.Generate((ulong)(first + i), CreatureOptions.Default with { Kind = RequestedKind.Walking }), 4);
        }

        output.WriteLine(figures.ToString());
        Assert.True(figures.All.Found >= 0.95 * figures.All.Steps, figures.ToString());
        Assert.True(figures.All.False <= 0.05 * (figures.All.Found + figures.All.False), figures.ToString());
    }
}
