using System;

namespace CreatureGen.Sampling;

/// <summary>A seed gave no creature that meets the options. Others may: a batch can go on without it.</summary>
public sealed class ImpossibleSeedException : ArgumentException
{
    /// <summary>Tells why.</summary>
    public ImpossibleSeedException(string message, string parameter)
        : base(message, parameter)
    {
    }
}
