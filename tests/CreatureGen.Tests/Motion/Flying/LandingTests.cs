using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Flying;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Flying;

/// <summary>How fliers come down.</summary>
public sealed class LandingTests
{
    [Fact]
    public void Who_lands_has_its_nose_up_and_its_wings_flared_before_its_legs_reach_the_ground()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Flapping))
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            FlightState state = FlightState.InAir(profile);
            float height = 6 * profile.LegLength;
            float dt = 0.01f * MathF.Sqrt(profile.LegLength);
            float raised = 0f;
            float flared = 0f;
            for (int i = 0; i < 3000 && state.Phase is FlightPhase.Airborne or FlightPhase.Landing; i++)
            {
                var input = new FlightInput(FlightIntent.Ground, 0.6f * profile.CruiseSpeed, 0f, -0.3f * profile.CruiseSpeed, height);
                RootDelta root = FlightMotion.Update(profile, input, ref state, dt, body.Local);
                height = Math.Max(0f, height + root.Shift.Y);
                if (state.Phase == FlightPhase.Landing && height > 0.9f * profile.LegLength)
                {
                    int trunk = profile.Chain.Body;
                    Quaternion turn = body.Rotations[trunk] * Quaternion.Inverse(profile.Skeleton.LocalRotations[trunk]);
                    raised = Math.Max(raised, MathF.Asin(Rotation.Rotate(turn, Vector3.UnitZ).Y));
                    flared = Math.Max(flared, (float)state.Flare.Value);
                }
            }

            Assert.Equal(FlightPhase.Settling, state.Phase);
            Assert.True(raised > 0.3f, FormattableString.Invariant($"{creature.Blueprint.Seed}: {raised} rad"));
            Assert.True(flared > 0.5f, FormattableString.Invariant($"{creature.Blueprint.Seed}: {flared}"));
        }
    }
}
