namespace CreatureGen.Tests.Gltf;

/// <summary>What a <see cref="SampleCreature"/> is made of.</summary>
/// <param name="Number">Tells creatures of equal counts apart: their proportions and colours follow from it.</param>
/// <param name="Rings">Rings of the body between its two poles.</param>
/// <param name="Segments">Segments around the body.</param>
/// <param name="Spine">Joints from the middle to the head.</param>
/// <param name="Tail">Joints from the middle to the tip of the tail.</param>
/// <param name="LegPairs">Pairs of legs.</param>
/// <param name="Fins">Closed membranes on the back.</param>
internal sealed record SampleShape(int Number, int Rings = 12, int Segments = 8, int Spine = 2, int Tail = 1, int LegPairs = 1, int Fins = 1)
{
    /// <summary>A shape for each number, of all counts that are small.</summary>
    public static SampleShape Of(int number) => new(
        number,
        Rings: 3 + (number % 17),
        Segments: 3 + (number % 11),
        Spine: 1 + (number % 4),
        Tail: 1 + (number % 3),
        LegPairs: number % 4,
        Fins: number % 3);
}
