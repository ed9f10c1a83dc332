using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>Every setting does something to a creature that moves in its way, and nothing to the others.</summary>
public sealed class SettingsTests
{
    private static readonly Dictionary<Type, BodyPlan> movers = new()
    {
        [typeof(WalkingSettings)] = BodyPlan.Digitigrade,
        [typeof(FlyingSettings)] = BodyPlan.Flapping,
        [typeof(SwimmingSettings)] = BodyPlan.Whale,
        [typeof(SlitheringSettings)] = BodyPlan.Legless,
    };

    public static TheoryData<string, string> Numbers
    {
        get
        {
            var data = new TheoryData<string, string>();
            foreach (Type mode in movers.Keys)
            {
                foreach (PropertyInfo property in mode.GetProperties().Where(p => p.PropertyType == typeof(float)))
                {
                    data.Add(mode.Name, property.Name);
                }
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void A_number_that_can_be_set_changes_the_motion_and_its_default_does_not(string mode, string name)
    {
        Type type = movers.Keys.Single(t => t.Name == mode);
        PropertyInfo property = type.GetProperty(name)!;
        Creature creature = Walkers.Of(movers[type], 3);
        Vector3[] plain = Moved(creature, MotionSettings.Default);
        Assert.Equal(plain, Moved(creature, With(type, property, (float)property.GetValue(Records(MotionSettings.Default)[type])!)));
        float other = 0.6f * (float)property.GetValue(Records(MotionSettings.Default)[type])!;
        Assert.NotEqual(plain, Moved(creature, With(type, property, other)));
        foreach (float bad in new[] { float.NaN, float.PositiveInfinity, -1f, 1e6f })
        {
            Assert.Contains(name, Assert.ThrowsAny<ArgumentException>(() => new CreatureAnimator(creature) { Settings = With(type, property, bad) }).Message, StringComparison.Ordinal);
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Flapping)]
    [InlineData(BodyPlan.Whale)]
    [InlineData(BodyPlan.Legless)]
    public void Settings_of_other_ways_of_moving_change_nothing(BodyPlan plan)
    {
        Creature creature = Walkers.Of(plan, 3);
        MotionSettings others = MotionSettings.Default;
        others.Walking = plan is BodyPlan.Digitigrade or BodyPlan.Flapping ? others.Walking : new WalkingSettings { Lift = 2f, Bounce = 2f, SpeedResponse = 1f };
        others.Flying = plan == BodyPlan.Flapping ? others.Flying : new FlyingSettings { Bank = 0f, BeatAmplitude = 0.5f };
        others.Swimming = plan == BodyPlan.Whale ? others.Swimming : new SwimmingSettings { Bank = 0f, BeatAmplitude = 0.5f };
        others.Slithering = plan == BodyPlan.Legless ? others.Slithering : new SlitheringSettings { Gait = SlitherGait.Rectilinear };
        Assert.Equal(Moved(creature, MotionSettings.Default), Moved(creature, others));
    }

    [Fact]
    public void Gravity_and_idle_life_are_shared_and_settings_without_a_record_are_refused()
    {
        Creature dog = Walkers.Of(BodyPlan.Digitigrade, 3);
        MotionSettings moon = MotionSettings.Default;
        moon.Gravity = 1.62f;
        Assert.NotEqual(Moved(dog, MotionSettings.Default), Moved(dog, moon));
        MotionSettings still = MotionSettings.Default;
        still.Idle = 0f;
        Assert.NotEqual(Moved(dog, MotionSettings.Default), Moved(dog, still));
        MotionSettings none = MotionSettings.Default;
        none.Flying = null!;
        Assert.Contains("Flying", Assert.Throws<ArgumentNullException>(() => new CreatureAnimator(dog) { Settings = none }).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_gaze_that_is_set_turns_the_head_as_it_says_and_none_gives_that_of_the_creature_back()
    {
        Creature dog = Walkers.Of(BodyPlan.Digitigrade, 3);
        Assert.True(Looked(new GazeSettings(10f, maxYaw: 0.2f)) < 0.25);
        Assert.True(Looked(new GazeSettings(10f, maxYaw: 1.2f)) > 0.5);
        Assert.Equal(Looked(null), Looked(null));

        double Looked(GazeSettings? settings)
        {
            var animator = new CreatureAnimator(dog) { GazeSettings = settings, LookAt = new Vector3(50f, 0.5f, 0f) };
            Walkers.Run(animator, 3f, 60f, default, FlatGround.Level);
            int head = dog.Skeleton.Joints.ToList().FindIndex(j => j.Role == JointRole.Head);
            return MovingPose.Between(dog.Skeleton.ModelRotations[head], animator.ModelPose.Rotations[head]);
        }
    }

    /// <summary>Places of all joints in the world, again and again, as a creature stands, speeds up, turns, slows down and stands.</summary>
    private static Vector3[] Moved(Creature creature, MotionSettings settings)
    {
        var animator = new CreatureAnimator(creature) { Settings = settings };
        bool flies = creature.Blueprint.Kind == LocomotionKind.Flying;
        float speed = creature.DefaultSpeed;
        var places = new List<Vector3>();
        for (int i = 0; i < 360; i++)
        {
            MotionInput input = i switch
            {
                < 60 => default,
                < 150 => new MotionInput(speed, Medium: flies ? MotionMedium.Air : MotionMedium.Ground),
                < 240 => new MotionInput(speed, 0.6f, Medium: flies ? MotionMedium.Air : MotionMedium.Ground),
                < 300 => new MotionInput(0.4f * speed, Medium: flies ? MotionMedium.Air : MotionMedium.Ground),
                _ => default,
            };
            animator.Update(1f / 60f, input, FlatGround.Level);
            if (i % 10 == 0)
            {
                foreach (Vector3 place in animator.ModelPose.Positions)
                {
                    places.Add(animator.Root.ToWorld(place));
                }
            }
        }

        return places.ToArray();
    }

    private static Dictionary<Type, object> Records(MotionSettings settings) => new()
    {
        [typeof(WalkingSettings)] = settings.Walking,
        [typeof(FlyingSettings)] = settings.Flying,
        [typeof(SwimmingSettings)] = settings.Swimming,
        [typeof(SlitheringSettings)] = settings.Slithering,
    };

    private static MotionSettings With(Type type, PropertyInfo property, float value)
    {
        object record = Activator.CreateInstance(type)!;
        property.SetValue(record, value);
        MotionSettings settings = MotionSettings.Default;
        settings.Walking = record as WalkingSettings ?? settings.Walking;
        settings.Flying = record as FlyingSettings ?? settings.Flying;
        settings.Swimming = record as SwimmingSettings ?? settings.Swimming;
        settings.Slithering = record as SlitheringSettings ?? settings.Slithering;
        return settings;
    }
}
