using System;
using System.Linq;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Swimming;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Swimming;

public sealed class SwimWaveTests
{
    public static TheoryData<ulong> Swimmers => [3, 4, 7, 12];

    /// <summary>Where the wave stands is a phase that grows from nose to tail; only the tail fin lags on its own account.</summary>
    [Theory]
    [MemberData(nameof(Swimmers))]
    public void The_wave_runs_from_the_head_to_the_tail(ulong seed)
    {
        SwimProfile profile = Profile(seed);
        int points = profile.Chain.Count;
        double last = double.NegativeInfinity;
        for (int p = 1; p < points; p++)
        {
            // Displacement is c·cos 2πφ + s·sin 2πφ: greatest at the phase atan2(s, c).
            double c = profile.Wave.Displacement(p, 1, 0);
            double s = profile.Wave.Displacement(p, 0, 1);
            double phase = Math.Atan2(s, c);
            if (double.IsFinite(last))
            {
                phase = last + Math.IEEERemainder(phase - last, 2 * Math.PI);
                Assert.True(phase > last - 1e-9, $"point {p} of {points}: {phase} after {last}");
            }

            last = phase;
        }
    }

    /// <summary>The head keeps only a share of the heading that the wave would give it.</summary>
    [Theory]
    [MemberData(nameof(Swimmers))]
    public void The_head_is_steadier_than_a_wave_would_have_it(ulong seed)
    {
        SwimProfile profile = Profile(seed);
        double fraction = profile.Kinematics.HeadFraction;
        Assert.InRange(fraction, 0, 0.9);
        double nose = (profile.Chain.Nose.Z - profile.Chain.Bones[0].Front.Z) / profile.Chain.Length;
        double next = (profile.Chain.Nose.Z - profile.Chain.Bones[1].Front.Z) / profile.Chain.Length;
        double Free(double along, double turns) => SwimKinematics.Envelope(profile.Style, along) * Math.Sin((2 * Math.PI * ((along / profile.Kinematics.Wavelength))) - turns);
        double Slope(Func<double, double> of) => Math.Max(Math.Abs(of(0)), Math.Abs(of(Math.PI / 2)));
        double free = Slope(turns => Free(nose, turns) - Free(next, turns));
        double kept = Slope(turns => profile.Wave.Displacement(0, Math.Cos(turns), Math.Sin(turns)) - profile.Wave.Displacement(1, Math.Cos(turns), Math.Sin(turns)));

        // The wave is then made as wide as the tail's sweep asks: the second bone, which is not steadied, tells by how much.
        double wide = Slope(turns => profile.Wave.Displacement(1, Math.Cos(turns), Math.Sin(turns))) / Slope(turns => Free(next, turns));
        Assert.Equal(fraction, kept / (free * wide), 0.02);
    }

    /// <summary>The offset that keeps the centre of mass on its way is the mean of the body's displacements, each by its mass.</summary>
    [Theory]
    [MemberData(nameof(Swimmers))]
    public void The_centre_of_mass_is_displaced_by_the_mean_of_the_body(ulong seed)
    {
        SwimProfile profile = Profile(seed);
        foreach (double turns in new[] { 0, 0.3, 1.1, 2.5 })
        {
            double c = Math.Cos(turns);
            double s = Math.Sin(turns);
            double mean = Enumerable.Range(0, profile.Chain.Count).Sum(b => profile.Chain.Bones[b].Mass * 0.5 * (profile.Wave.Displacement(b, c, s) + profile.Wave.Displacement(b + 1, c, s)));
            Assert.Equal(mean, profile.Wave.Mean(c, s), 1e-9);
        }
    }

    private static SwimProfile Profile(ulong seed) => new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming })).Swim!;
}
