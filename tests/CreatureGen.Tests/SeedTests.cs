using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests;

public sealed class SeedTests
{
    [Fact]
    public void A_child_depends_on_its_name()
    {
        var root = new Seed(42);
        Assert.NotEqual(root.Child("limb").Value, root.Child("wing").Value);
        Assert.Equal(root.Child("limb"), root.Child("limb"));
    }
}
