"""twist_stamper: conversion between Twist and TwistStamped."""
