namespace Unity.Collections;

[AttributeUsage(AttributeTargets.Field | AttributeTargets.Parameter)]
public sealed class ReadOnlyAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Field)]
public sealed class WriteOnlyAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Field)]
public sealed class DeallocateOnJobCompletionAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Field)]
public sealed class NativeDisableParallelForRestrictionAttribute : Attribute { }
