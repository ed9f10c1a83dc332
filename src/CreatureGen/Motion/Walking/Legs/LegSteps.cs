using System.Numerics;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>What of the steps of a leg bounds their length.</summary>
/// <param name="Home">Where the foot belongs under a body that goes.</param>
/// <param name="Bias">Where the foot comes down, stance lengths ahead of home.</param>
/// <param name="Crouch">Lowering of the body, leg lengths.</param>
/// <param name="Slide">Share of the foot's way that the girdle goes along.</param>
/// <param name="Track">Factor on the distance of the tracks.</param>
/// <param name="Yaw">Yaw of the girdle with its feet, radians for each leg length: it gives legs out to the side more way.</param>
/// <param name="Slope">Rise of the ground along the way.</param>
/// <param name="Shift">How far the foot is ahead of its hip for that slope, metres.</param>
internal readonly record struct LegSteps(Vector3 Home, float Bias, float Crouch, float Slide, float Track, float Yaw, float Slope, float Shift);
