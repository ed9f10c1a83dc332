using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Where feet belong under a body in a gait and on a slope.</summary>
internal static class GaitFootholds
{
    /// <summary>Rise of the ground that counts at most.</summary>
    private const float MaxSlope = 0.5f;

    /// <summary>Where a foot belongs under the body: its rest place, drawn in towards the middle and shifted ahead or back with the gait, model space.</summary>
    /// <param name="body">Gives the legs.</param>
    /// <param name="leg">Which.</param>
    /// <param name="activity">0 stands, 1 walks.</param>
    /// <param name="clock">Gives the gait.</param>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="slope">Rise of the ground along the way.</param>
    public static Vector3 Under(LeggedBody body, int leg, float activity, GaitClock clock, float speed, float slope)
    {
        LegRig shape = body.Legs[leg];
        Vector3 home = shape.Home + ((body.GoingHomes[leg] - shape.Home) * activity);
        float track = shape.Track(clock.Shape.Track, body.IsBiped ? clock.Shape.Lift : 0f);
        home.X *= 1f - ((1f - track) * activity);
        bool sprawls = shape.Traits.Kind.Outline.Sprawling && body.Rows == 2;
        float bias = sprawls ? 0f : body.Rows == 2 ? (shape.Row == 0 ? clock.Shape.HindBias : clock.Shape.ForeBias) : body.IsBiped ? clock.Shape.HindBias : 0f;
        home.Z += bias * clock.Duty * speed / clock.Frequency * activity;
        home.Z += SlopeShift.Ahead(shape, body.Rows, home.Z, Scalar.Clamp(slope, -MaxSlope, MaxSlope)) * activity;
        return home;
    }
}
