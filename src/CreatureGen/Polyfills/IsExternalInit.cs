#if !NET5_0_OR_GREATER
namespace System.Runtime.CompilerServices
{
    /// <summary>Lets the compiler emit init-only properties for netstandard2.1.</summary>
    internal static class IsExternalInit
    {
    }
}
#endif
