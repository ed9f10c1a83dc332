using System.Numerics;

namespace CreatureGen.Motion;

/// <summary>Ground with water on it: who goes on legs swims where it is too deep to stand, and walks again where it is not.</summary>
public interface IWaterGround : IGround
{
    /// <summary>How far a place is below the surface of the water, whatever is between.</summary>
    /// <param name="place">World space, metres.</param>
    /// <returns>Metres; negative above the surface, negative infinity where there is no water. What is not a number counts as no water.</returns>
    float DepthAt(Vector3 place);
}
