using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Working;

/// <summary>One seed gave no creature within options that others may meet.</summary>
internal sealed class ImpossibleSeed(string message) : UsageError(message);
