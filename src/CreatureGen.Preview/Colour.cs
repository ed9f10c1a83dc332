namespace CreatureGen.Preview;

internal static class Colour
{
}
