using System;
using System.Collections.Generic;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Gaze;

public sealed class GlancesTests
{
    private static readonly Seed seed = new Seed(7).Child("glances");

    [Fact]
    public void Glances_stay_in_range_move_smoothly_and_hold_still_most_of_the_time()
    {
        GlanceSettings settings = GlanceSettings.Default;
        LookAngles last = Glances.At(seed, 0, settings);
        int still = 0;
        var places = new HashSet<float>();
        for (int i = 1; i < 60000; i++)
        {
            LookAngles now = Glances.At(seed, i * 0.005, settings);
            Assert.InRange(now.Yaw, -0.85f, 0.85f);
            Assert.InRange(now.Pitch, -0.25f, 0.25f);
            Assert.True(Math.Abs(now.Yaw - last.Yaw) < 0.07f, "a jump");
            if (now == last)
            {
                still++;
                places.Add(now.Yaw);
            }

            last = now;
        }

        Assert.InRange(still / 60000.0, 0.75, 0.9);
        Assert.InRange(places.Count, 90, 170);
    }

    [Fact]
    public void The_same_moment_is_the_same_in_any_order_and_seeds_differ()
    {
        LookAngles late = Glances.At(seed, 1234.5, GlanceSettings.Default);
        Glances.At(seed, -3, GlanceSettings.Default);
        Assert.Equal(late, Glances.At(seed, 1234.5, GlanceSettings.Default));
        int same = 0;
        for (int i = 0; i < 100; i++)
        {
            same += Glances.At(new Seed((ulong)i), 55, GlanceSettings.Default).Yaw == Glances.At(new Seed((ulong)i + 100), 55, GlanceSettings.Default).Yaw ? 1 : 0;
        }

        Assert.True(same < 20);
        Assert.Throws<ArgumentException>(() => Glances.At(seed, double.NaN, GlanceSettings.Default));
        Assert.Throws<ArgumentException>(() => Glances.At(seed, 0, default));
    }

    [Fact]
    public void Lids_shut_fully_about_once_a_period_and_are_open_at_nearly_all_times()
    {
        int blinks = 0;
        int shut = 0;
        bool was = false;
        float last = 0f;
        for (int i = 0; i < 200000; i++)
        {
            float now = Blinks.At(seed, i * 0.005, 4f);
            Assert.InRange(now, 0f, 1f);
            Assert.True(Math.Abs(now - last) < 0.12f);
            blinks += now == 1f && !was ? 1 : 0;
            was = now == 1f;
            shut += now > 0.5f ? 1 : 0;
            last = now;
        }

        Assert.InRange(blinks, 250, 330);
        Assert.InRange(shut / 200000.0, 0.02, 0.08);
    }
}
