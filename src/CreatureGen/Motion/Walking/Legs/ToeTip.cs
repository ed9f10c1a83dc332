using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>The round front end of a sole, over which a foot rolls off the ground without sliding: a circle through the lowest of the toes as they are turned down a little and far.</summary>
/// <param name="Ahead">From the ball to where the flat of the sole ends and the circle begins, level, metres.</param>
/// <param name="Radius">Of the circle, metres; 0 of a sole that ends in an edge.</param>
internal readonly record struct ToeTip(float Ahead, float Radius)
{
    /// <summary>Cosine and sine of the two turns at which the circle touches the ground as the toes do: 0.3 and 0.8 rad.</summary>
    private const float SlightCosine = 0.95534f;
    private const float SlightSine = 0.29552f;
    private const float FarCosine = 0.69671f;
    private const float FarSine = 0.71736f;

    /// <summary>Part of their length from which on toes touch the ground with nothing but their tip.</summary>
    private const float Edge = 0.98f;

    /// <summary>How far the ball has come ahead and how high it is above the ground where the foot is turned down about this end, metres.</summary>
    /// <param name="pitch">Radians, toes down, at least 0.</param>
    /// <param name="height">Of the ball above the ground, metres.</param>
    public Vector2 BallAt(float pitch, float height)
    {
        FastTrigonometry.SinCos(pitch, out float sine, out float cosine);
        return new Vector2((Ahead * (1f - cosine)) + (Radius * pitch) + ((height - Radius) * sine), (Ahead * sine) + (Radius * (1f - cosine)) + (height * cosine));
    }

    /// <summary>What is found of toes, point by point: how low they come at the two turns.</summary>
    public struct Profile
    {
        private float slight;
        private float far;
        private bool seen;

        /// <summary>Takes a point in.</summary>
        /// <param name="along">From the ball towards the toes, level, metres.</param>
        /// <param name="height">Above the ground, metres.</param>
        public void Add(float along, float height)
        {
            float atSlight = (height * SlightCosine) - (along * SlightSine);
            float atFar = (height * FarCosine) - (along * FarSine);
            (slight, far) = seen ? (Math.Min(slight, atSlight), Math.Min(far, atFar)) : (atSlight, atFar);
            seen = true;
        }

        /// <summary>The end of the sole that comes as low: r (cos θ − 1) − c sin θ.</summary>
        /// <param name="toe">From the ball to the tip of the toes, for those of which no point was seen, metres.</param>
        public readonly ToeTip Fit(float toe)
        {
            float determinant = (FarSine * (1f - SlightCosine)) - (SlightSine * (1f - FarCosine));
            float radius = ((slight * -FarSine) + (far * SlightSine)) / determinant;
            var found = radius > 0f ? new ToeTip(-(slight + (radius * (1f - SlightCosine))) / SlightSine, radius) : new ToeTip(-far / FarSine, 0f);
            return seen && (radius > 0f || found.Ahead < Edge * toe) ? found : new ToeTip(toe, 0f);
        }
    }
}
