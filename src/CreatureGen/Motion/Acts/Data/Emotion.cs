using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>What a creature feels, in three numbers of −1..1: two cannot tell a threat from fear. The default is calm and shows nothing.</summary>
/// <remarks>Based on: J. A. Russell, "A circumplex model of affect" (1980); A. Mehrabian and J. A. Russell, "An Approach to Environmental Psychology" (1974), for the third.</remarks>
/// <param name="Arousal">Asleep to excited.</param>
/// <param name="Valence">Bad to good.</param>
/// <param name="Boldness">Away from it to towards it.</param>
public readonly record struct Emotion(float Arousal, float Valence, float Boldness)
{
    /// <summary>Throws unless all numbers are finite and in their range.</summary>
    internal void ThrowIfInvalid()
    {
        Finite.RequireWithin(Arousal, -1f, 1f, nameof(Arousal));
        Finite.RequireWithin(Valence, -1f, 1f, nameof(Valence));
        Finite.RequireWithin(Boldness, -1f, 1f, nameof(Boldness));
    }
}
