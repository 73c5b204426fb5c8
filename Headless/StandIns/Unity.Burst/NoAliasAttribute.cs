using System;

namespace Unity.Burst
{
    [AttributeUsage(AttributeTargets.Parameter | AttributeTargets.ReturnValue | AttributeTargets.Struct | AttributeTargets.Field)]
    public class NoAliasAttribute : Attribute
    {
    }
}
