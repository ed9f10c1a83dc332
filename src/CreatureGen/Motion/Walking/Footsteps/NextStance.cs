using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Where a foot will stand next.</summary>
/// <param name="Root">Displacement of the root until then.</param>
/// <param name="Yaw">Turn of the root until then, radians.</param>
/// <param name="Home">Where the foot belongs under the body then, model space.</param>
internal readonly record struct NextStance(Vector3 Root, float Yaw, Vector3 Home)
{
    /// <summary>The place of the foot, model space at present.</summary>
    public Vector3 Place => Root + Rotation.Rotate(AxisRotation.Yaw(Yaw), Home);

    /// <summary>Under where the body will be in the middle of the coming stance, predicted along the arc that it follows.</summary>
    /// <param name="body">The body.</param>
    /// <param name="leg">Which foot.</param>
    /// <param name="step">The moment.</param>
    /// <param name="offset">What it stands away from its home where the body stands, metres of the model.</param>
    /// <param name="ahead">Seconds to the middle of that stance.</param>
    public static NextStance Going(LeggedBody body, int leg, in StepContext step, Vector3 offset, float ahead)
    {
        Vector3 there = step.RootVelocity.Predict(ahead, out float yaw);
        Vector3 home = GaitFootholds.Under(body, leg, step.Activity, step.Clock, step.RootVelocity.Speed, step.Slope);
        return new NextStance(there, yaw, home + (offset * (1f - step.Activity)));
    }

    /// <summary>Under where the body will come to rest: a foot that goes there has no step to take any more.</summary>
    /// <param name="body">The body.</param>
    /// <param name="leg">Which foot.</param>
    /// <param name="step">The moment, of a body that stops.</param>
    /// <param name="offset">What it stands away from its home where the body stands, metres of the model.</param>
    public static NextStance Last(LeggedBody body, int leg, in StepContext step, Vector3 offset) =>
        new(step.Rest, step.RestYaw, GaitFootholds.Under(body, leg, 0f, step.Clock, 0f, 0f) + offset);

    /// <summary>Whether the leg reaches the place as the foot comes down.</summary>
    /// <param name="body">The body.</param>
    /// <param name="leg">Which foot.</param>
    /// <param name="step">The moment.</param>
    /// <param name="flight">Seconds until it comes down.</param>
    public bool IsReached(LeggedBody body, int leg, in StepContext step, float flight)
    {
        Vector3 landing = step.RootVelocity.Predict(flight, out float turned);
        Vector3 away = Rotation.Rotate(AxisRotation.Yaw(-turned), Place - landing) - Home;
        StepRange range = body.StepRanges[leg];
        return Scalar.Square(away.X / range.Aside) + Scalar.Square(away.Z / range.Ahead) <= 1f;
    }
}
