using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>The rise of the ground along the way, as the feet feel it: the line through their places, over some steps, so that hills no longer than the body do not count.</summary>
internal struct GroundSlope
{
    /// <summary>How quickly it follows, per second.</summary>
    private const float Rate = 3f;

    /// <summary>The steepest that is taken for a slope.</summary>
    private const float Steepest = 0.6f;

    /// <summary>Spread of the feet along the way, leg lengths, below which they say little: they stand side by side.</summary>
    private const float MinSpread = 0.05f;

    private ExponentialDecay decay;
    private float together;
    private float spread;

    /// <summary>Metres up for each metre ahead.</summary>
    public float Rise { get; private set; }

    /// <summary>Feels the ground under all feet.</summary>
    /// <param name="feet">Their places as last posed.</param>
    /// <param name="legLength">Metres.</param>
    /// <param name="dt">Seconds since the last time.</param>
    public void Feel(ReadOnlySpan<Foot> feet, float legLength, float dt)
    {
        float fraction = decay.Fraction(Rate * dt);
        Measure(feet, out float nowTogether, out float nowSpread);
        together += (nowTogether - together) * fraction;
        spread += (nowSpread - spread) * fraction;
        Settle(legLength);
    }

    /// <summary>Takes the ground under all feet as it is at present.</summary>
    public void Reset(ReadOnlySpan<Foot> feet, float legLength)
    {
        Measure(feet, out together, out spread);
        Settle(legLength);
    }

    private void Settle(float legLength)
    {
        float min = MinSpread * legLength;
        Rise = Scalar.Clamp(together / (spread + (min * min)), -Steepest, Steepest);
    }

    /// <summary>Mean product of the feet's distances from their middle, ahead and up, and mean square of those ahead.</summary>
    private static void Measure(ReadOnlySpan<Foot> feet, out float together, out float spread)
    {
        float z = 0f;
        float y = 0f;
        float zy = 0f;
        float zz = 0f;
        for (int i = 0; i < feet.Length; i++)
        {
            float ahead = feet[i].Base.Z;
            float up = feet[i].Base.Y;
            z += ahead;
            y += up;
            zy += ahead * up;
            zz += ahead * ahead;
        }

        float fraction = 1f / feet.Length;
        together = (zy - (z * y * fraction)) * fraction;
        spread = (zz - (z * z * fraction)) * fraction;
    }
}
